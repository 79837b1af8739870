// Reads passes, graphs and the scene on a thread of its own, so that the window goes on meanwhile.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <passgraph/core/graph_file.hpp>
#include <passgraph/scene/scene.hpp>
#include <passgraph/shader/pass_file_cache.hpp>

#include "tool/view/file_watch.hpp"

namespace passgraph::tool::view {

/// What is read, and from where.
struct LoaderFiles {
    std::vector<std::string> pass_folders; ///< later ones replace passes of earlier ones
    std::vector<std::string> graphs;
    std::string scene; ///< "": none
};

/// Passes and graphs as far as they could be read; what could not stays what it was the last time.
struct LoadedPasses {
    std::shared_ptr<const PassLibrary> library;
    std::vector<std::shared_ptr<const GraphDescription>> graphs; ///< as the files; nullptr: never could be read
    Errors errors;
};

struct LoadedScene {
    std::shared_ptr<const Scene> scene; ///< nullptr on errors
    Errors errors;
};

/// A file that cannot be read right after it was written may be half-written: it is read again until it is kSettled old,
/// and only then are its errors told.
class Loader {
public:
    static constexpr std::chrono::milliseconds kSettled{400};

    /// `on_done` is called on the loader's thread when there is something to take.
    Loader(LoaderFiles files, std::function<void()> on_done);
    ~Loader();
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    void request_passes();
    void request_scene();
    /// The latest results, once.
    std::optional<LoadedPasses> take_passes();
    std::optional<LoadedScene> take_scene();
    /// Something is to be read, or to be taken.
    bool is_busy();

private:
    void work();
    LoadedPasses load_passes();
    LoadedScene load_scene_file() const;
    template <class Load> auto load_settled(const Load& load, const WatchedPaths& files);

    const LoaderFiles files_;
    const std::function<void()> on_done_;
    PassFileCache cache_;   ///< of the thread
    LoadedPasses last_good_; ///< of the thread
    std::mutex mutex_;
    std::condition_variable changed_;
    bool wants_passes_ = false;
    bool wants_scene_ = false;
    bool is_working_ = false;
    bool is_ending_ = false;
    std::optional<LoadedPasses> passes_;
    std::optional<LoadedScene> scene_;
    std::thread thread_; ///< last: it uses the others
};

} // namespace passgraph::tool::view
