// The loading thread.
#include "tool/view/loader.hpp"

#include <passgraph/scene/scene_file.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "tool/library.hpp"
#include "tool/view/scene_files.hpp"

namespace passgraph::tool::view {

Loader::Loader(LoaderFiles files, std::function<void()> on_done)
    : files_(std::move(files)), on_done_(std::move(on_done)), thread_([this] { work(); })
{
}

Loader::~Loader()
{
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Loader::request_passes()
{
    {
        const std::lock_guard lock(mutex_);
        wants_passes_ = true;
    }
    changed_.notify_all();
}

void Loader::request_scene()
{
    {
        const std::lock_guard lock(mutex_);
        wants_scene_ = true;
    }
    changed_.notify_all();
}

std::optional<LoadedPasses> Loader::take_passes()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(passes_, std::nullopt);
}

std::optional<LoadedScene> Loader::take_scene()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(scene_, std::nullopt);
}

bool Loader::is_busy()
{
    const std::lock_guard lock(mutex_);
    return wants_passes_ || wants_scene_ || is_working_ || passes_ || scene_;
}

/// Loads; after errors once more as long as one of the files is young.
template <class Load> auto Loader::load_settled(const Load& load, const WatchedPaths& files)
{
    auto loaded = load();
    // A clock of another machine may be ahead for ever, so the number of tries is bounded.
    for (int tries = 0; !loaded.errors.empty() && tries < 12; ++tries) {
        const auto age = std::filesystem::file_time_type::clock::now() - FileWatch::latest(files);
        std::unique_lock lock(mutex_);
        if (age > kSettled || changed_.wait_for(lock, std::chrono::milliseconds(50), [&] { return is_ending_; }))
            break;
        lock.unlock();
        loaded = load();
    }
    return loaded;
}

void Loader::work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return is_ending_ || wants_passes_ || wants_scene_; });
        if (is_ending_)
            return;
        const bool reads_passes = std::exchange(wants_passes_, false);
        const bool reads_scene = !reads_passes && std::exchange(wants_scene_, false);
        is_working_ = true;
        lock.unlock();
        std::optional<LoadedPasses> passes;
        std::optional<LoadedScene> scene;
        if (reads_passes)
            passes = load_settled([this] { return load_passes(); }, {files_.graphs, files_.pass_folders});
        if (reads_scene)
            scene = load_settled([this] { return load_scene_file(); }, {files_of_scene(files_.scene), {}});
        lock.lock();
        is_working_ = false;
        if (passes)
            passes_ = std::move(passes);
        if (scene)
            scene_ = std::move(scene);
        on_done_();
    }
}

LoadedPasses Loader::load_passes()
{
    // Built-in passes first, then what was good the last time: a pass that cannot be read now stays as it was.
    auto library = std::make_shared<PassLibrary>(last_good_.library ? *last_good_.library : builtin_passes());
    LoadedPasses loaded;
    for (const std::string& folder : files_.pass_folders)
        if (const Result<void> read = load_pass_folder(folder, *library, common_folder(), &cache_); !read)
            append(loaded.errors, read.error());
    loaded.library = library;
    loaded.graphs = last_good_.graphs;
    loaded.graphs.resize(files_.graphs.size());
    for (size_t i = 0; i < files_.graphs.size(); ++i) {
        const Result<std::string> text = read_text_file(files_.graphs[i]);
        Result<GraphDescription> graph =
            text ? read_graph_description(*text, files_.graphs[i]) : Result<GraphDescription>(tl::unexpected(text.error()));
        if (graph)
            loaded.graphs[i] = std::make_shared<const GraphDescription>(std::move(*graph));
        else
            append(loaded.errors, graph.error());
    }
    last_good_ = loaded;
    return loaded;
}

LoadedScene Loader::load_scene_file() const
{
    if (files_.scene.empty())
        return {};
    Result<Scene> scene = load_scene(files_.scene);
    if (!scene)
        return {nullptr, scene.error()};
    return {std::make_shared<const Scene>(std::move(*scene)), {}};
}

} // namespace passgraph::tool::view
