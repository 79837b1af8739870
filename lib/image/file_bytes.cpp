// Reading a whole file and replacing a whole file, with errors that say what to do.
#include "image/file_bytes.hpp"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace passgraph::image_io
{

namespace fs = std::filesystem;

namespace
{

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string hint_for_missing(const fs::path& path)
{
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code failed;
    if (!fs::is_directory(folder, failed))
        return fmt::format("there is no folder `{}`", folder.string());
    std::vector<std::string> names;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
        names.push_back(it->path().filename().string());
    const std::string near = closest(path.filename().string(), names);
    return near.empty() ? std::string() : fmt::format("did you mean `{}`?", near);
}

tl::unexpected<Errors> unreadable(const std::string& path, std::string_view reason)
{
    return fail({.code = "file_unreadable", .message = fmt::format("cannot read `{}`: {}", path, reason)});
}

tl::unexpected<Errors> unwritable(const std::string& path, std::string_view reason, std::string hint = {})
{
    return fail({.code = "file_unwritable",
                 .message = fmt::format("cannot write `{}`: {}", path, reason),
                 .hint = std::move(hint)});
}

/// True when every byte reached the file; errno says why not.
bool write_all(int descriptor, std::span<const uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return true;
}

} // namespace

Result<FileBytes> read_file(const std::string& path)
{
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found)
        return fail({.code = "file_missing",
                     .message = fmt::format("there is no file `{}`", path),
                     .hint = hint_for_missing(path)});
    if (fs::is_directory(status))
        return unreadable(path, "it is a folder");
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return unreadable(path, std::strerror(errno));
    if (std::fseek(file.get(), 0, SEEK_END) != 0)
        return unreadable(path, "it is not a regular file");
    const long size = std::ftell(file.get());
    if (size < 0)
        return unreadable(path, std::strerror(errno));
    if (size > INT_MAX - static_cast<long>(kSlack))
        return fail({.code = "picture_too_large", .message = fmt::format("`{}` has more than 2 GiB", path)});
    std::rewind(file.get());
    FileBytes bytes;
    try {
        bytes.storage.resize(static_cast<size_t>(size) + kSlack);
    } catch (const std::bad_alloc&) {
        return unreadable(path, "it does not fit into memory");
    }
    if (std::fread(bytes.storage.data(), 1, static_cast<size_t>(size), file.get()) != static_cast<size_t>(size))
        return unreadable(path, "it could not be read to its end");
    return bytes;
}

Result<void> write_file(const std::string& path, std::span<const uint8_t> bytes)
{
    const fs::path target(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code failed;
    if (!fs::is_directory(folder, failed))
        return unwritable(path, fmt::format("there is no folder `{}`", folder.string()),
                          fmt::format("mkdir -p {}", folder.string()));
    if (fs::is_directory(target, failed))
        return unwritable(path, "it is a folder");

    static std::atomic<unsigned> count{0};
    const std::string partial =
        (folder / fmt::format(".{}.{}.{}", target.filename().string(), ::getpid(), count++)).string();
    const int descriptor = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return unwritable(path, std::strerror(errno), "may you write to its folder?");
    const bool is_written = write_all(descriptor, bytes);
    int reason = is_written ? 0 : errno;
    if (::close(descriptor) != 0 && reason == 0)
        reason = errno;
    if (reason == 0 && std::rename(partial.c_str(), path.c_str()) != 0)
        reason = errno;
    if (reason == 0)
        return {};
    ::unlink(partial.c_str());
    return unwritable(path, std::strerror(reason));
}

} // namespace passgraph::image_io
