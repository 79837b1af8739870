// A folder for one test, and files written byte by byte.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "passgraph/image/image_file.hpp"

/// A new empty folder that is gone after the test.
class Scratch
{
public:
    Scratch()
    {
        static int count = 0;
        folder_ = std::filesystem::temp_directory_path() /
                  ("passgraph_image_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
    }
    ~Scratch() { std::filesystem::remove_all(folder_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string operator/(const std::string& name) const { return (folder_ / name).string(); }
    std::string folder() const { return folder_.string(); }
    size_t file_count() const
    {
        return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

private:
    std::filesystem::path folder_;
};

inline void write_bytes(const std::string& path, const std::vector<uint8_t>& bytes)
{
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline void write_text(const std::string& path, const std::string& text)
{
    write_bytes(path, std::vector<uint8_t>(text.begin(), text.end()));
}

inline std::vector<uint8_t> read_bytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A picture in which every number differs from its neighbours, in [0, 1].
inline passgraph::Picture gradient(passgraph::Extent extent, int channels)
{
    passgraph::Picture picture(extent, channels);
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = static_cast<float>((i * 37) % 256) / 255.0f;
    return picture;
}

/// The code of the first error, or "" when there is a value.
template <class Value> std::string code_of(const passgraph::Result<Value>& result)
{
    return result ? std::string() : result.error().front().code;
}
