// A folder for one test, gone after it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace passgraph::test {

class ScratchFolder {
public:
    ScratchFolder()
    {
        static int count = 0;
        folder_ = (std::filesystem::temp_directory_path() / ("passgraph_view_" + std::to_string(::getpid()) + "_" + std::to_string(count++))).string();
        std::filesystem::create_directories(folder_);
    }
    ~ScratchFolder() { std::filesystem::remove_all(folder_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name = "") const { return name.empty() ? folder_ : folder_ + "/" + name; }
    std::string write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

private:
    std::string folder_;
};

} // namespace passgraph::test
