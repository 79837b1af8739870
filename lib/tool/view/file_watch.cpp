// Scanning and comparing.
#include "tool/view/file_watch.hpp"

#include <algorithm>
#include <optional>

#include <sys/stat.h>

namespace passgraph::tool::view {
namespace {

namespace fs = std::filesystem;

bool counts(const fs::path& file)
{
    return file.extension() == ".glsl" || file.extension() == ".json";
}

std::uint64_t inode_of(const std::string& file)
{
    struct stat found{}; // an editor that renames a new file over the old one may keep time and size
    return ::stat(file.c_str(), &found) == 0 ? static_cast<std::uint64_t>(found.st_ino) : 0;
}

} // namespace

FileWatch::FileWatch(WatchedPaths paths) : paths_(std::move(paths)), known_(scan()) {}

std::map<std::string, FileWatch::Look> FileWatch::scan() const
{
    std::map<std::string, Look> looks;
    const auto add = [&](const fs::path& path) {
        std::error_code failed;
        Look look{fs::last_write_time(path, failed), 0, 0};
        if (failed)
            return;
        look.size = fs::file_size(path, failed);
        look.inode = inode_of(path.string());
        looks.emplace(path.string(), look);
    };
    for (const std::string& file : paths_.files)
        add(file);
    for (const std::string& folder : paths_.folders) {
        std::error_code failed;
        for (auto entry = fs::recursive_directory_iterator(folder, failed); !failed && entry != fs::recursive_directory_iterator();
             entry.increment(failed))
            if (counts(entry->path()))
                add(entry->path());
    }
    return looks;
}

std::vector<std::string> FileWatch::look()
{
    std::map<std::string, Look> now = scan();
    std::vector<std::string> changed;
    for (const auto& [path, look] : now)
        if (const auto known = known_.find(path); known == known_.end() || !(known->second == look))
            changed.push_back(path);
    for (const auto& [path, look] : known_)
        if (!now.contains(path))
            changed.push_back(path);
    known_ = std::move(now);
    return changed;
}

void FileWatch::watch(WatchedPaths paths)
{
    paths_ = std::move(paths);
    for (auto& [path, look] : scan())
        known_.try_emplace(path, look);
    const auto now = scan();
    std::erase_if(known_, [&](const auto& known) { return !now.contains(known.first); });
}

fs::file_time_type FileWatch::latest(const WatchedPaths& paths)
{
    fs::file_time_type latest = fs::file_time_type::min();
    for (const auto& [path, look] : FileWatch(paths).known_)
        latest = std::max(latest, look.time);
    return latest;
}

fs::file_time_type FileWatch::latest(const std::vector<std::string>& files)
{
    fs::file_time_type latest = fs::file_time_type::min();
    for (const std::string& file : files) {
        std::error_code failed;
        const fs::file_time_type time = fs::last_write_time(file, failed);
        if (!failed)
            latest = std::max(latest, time);
    }
    return latest;
}

} // namespace passgraph::tool::view
