// Processes, files and patience.
#include "view/desk.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <passgraph/image/image_file.hpp>

#include "support/catch.hpp"

namespace passgraph::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(60); // only a failing test waits that long

/// A child process with its output in files; `pipe_end` stays open in it.
pid_t start(const std::vector<std::string>& words, const std::string& out, const std::string& err)
{
    std::vector<std::string> argv = words;
    std::vector<char*> pointers;
    for (std::string& word : argv)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (to_out < 0 || to_err < 0 || ::dup2(to_out, 1) < 0 || ::dup2(to_err, 2) < 0)
            ::_exit(126);
        ::execvp(pointers[0], pointers.data());
        ::_exit(127);
    }
    return child;
}

void end(pid_t child)
{
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
}

std::string run(const std::string& command)
{
    std::string out;
    FILE* pipe = ::popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    char buffer[256];
    while (const size_t count = ::fread(buffer, 1, sizeof buffer, pipe))
        out.append(buffer, count);
    ::pclose(pipe);
    return out;
}

std::string content(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Condition> bool comes_true(const Condition& condition)
{
    const auto deadline = Clock::now() + kPatience;
    while (!condition()) {
        if (Clock::now() > deadline)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

struct Screen {
    std::string name;
    pid_t server = -1;
    pid_t manager = -1;

    Screen()
    {
        for (const char* tool : {"Xvfb", "openbox", "xdotool"}) {
            INFO("the tests of the window need " << tool << ": install xvfb, openbox and xdotool");
            REQUIRE(!run(std::string("command -v ") + tool).empty());
        }
        int ends[2];
        REQUIRE(::pipe(ends) == 0);
        // The server looks for a free number and tells it.
        server = start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset"}, "/dev/null", "/dev/null");
        ::close(ends[1]);
        char letter = 0;
        while (::read(ends[0], &letter, 1) == 1 && letter != '\n')
            name += letter;
        ::close(ends[0]);
        INFO("Xvfb did not start");
        REQUIRE(!name.empty());
        name = ":" + name;
        ::setenv("DISPLAY", name.c_str(), 1);
        manager = start({"openbox"}, "/dev/null", "/dev/null");
    }
    ~Screen()
    {
        end(manager);
        end(server);
    }
};

} // namespace

const std::string& display()
{
    static const Screen screen;
    return screen.name;
}

Desk::Desk(const std::vector<std::string>& more_words)
{
    display();
    static int count = 0;
    folder_ = (fs::temp_directory_path() / ("passgraph_window_" + std::to_string(::getpid()) + "_" + std::to_string(count++))).string();
    fs::create_directories(folder_ + "/pictures");
    fs::create_directories(folder_ + "/scenes");
    const fs::path source = PASSGRAPH_SOURCE_DIR;
    const fs::path demo = source / "samples/deferred_demo";
    fs::copy(source / "passes", folder_ + "/passes", fs::copy_options::recursive);
    for (const char* stack : {"bloom", "pixelated", "night"})
        fs::copy(demo / (std::string(stack) + ".graph.json"), folder_);
    fs::copy(demo / "resources/scenes/night_lamp.scene.json", folder_ + "/scenes");
    fs::create_directory_symlink(demo / "resources/models", folder_ + "/models");
    fs::create_directory_symlink(demo / "resources/sky", folder_ + "/sky");
    std::vector<std::string> words = {PASSGRAPH_PROGRAM, "view", path("bloom.graph.json"), path("pixelated.graph.json"), path("night.graph.json"),
                                      "--scene", path("scenes/night_lamp.scene.json"), "--size", "320x180", "--pictures", path("pictures"),
                                      "--passes", path("passes")};
    words.insert(words.end(), more_words.begin(), more_words.end());
    program_ = start(words, path("stdout"), path("stderr"));
    const bool is_there = comes_true([&] {
        window_ = run("xdotool search --onlyvisible --name passgraph 2>/dev/null | tail -1");
        window_.erase(std::remove(window_.begin(), window_.end(), '\n'), window_.end());
        return !window_.empty() || !is_running();
    });
    const bool runs = is_running();
    INFO("exit code " << exit_code_ << "\n" << messages());
    REQUIRE(runs);
    REQUIRE(is_there);
    // The manager gives it the keyboard; it may still be busy with the frame.
    CHECK(comes_true([&] { return run("xdotool getwindowfocus 2>/dev/null").starts_with(window_); }));
}

Desk::~Desk()
{
    if (is_running())
        end(program_);
    fs::remove_all(folder_);
}

void Desk::input(const std::string& words) { run("xdotool " + words); }
void Desk::window(const std::string& verb, const std::string& words) { run("xdotool " + verb + " " + window_ + " " + words); }
void Desk::point_at(int x, int y) { run("xdotool mousemove --window " + window_ + " " + std::to_string(x) + " " + std::to_string(y)); }

Picture Desk::picture()
{
    const auto files = [&] {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path("pictures")))
            if (entry.path().extension() == ".png")
                names.push_back(entry.path().string());
        return names;
    };
    for (const std::string& old : files())
        fs::remove(old);
    // A key is lost while the window is not mapped, and there is no picture before the first frame: press again.
    std::vector<std::string> saved;
    for (int tries = 0; tries < 30 && saved.empty(); ++tries) {
        key("p");
        const auto deadline = Clock::now() + std::chrono::seconds(2);
        while (saved.empty() && Clock::now() < deadline) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            saved = files();
        }
    }
    INFO(messages());
    REQUIRE(!saved.empty());
    const Result<Picture> picture = read_picture(saved.front(), Transfer::as_is);
    REQUIRE(picture);
    return *picture;
}

Picture Desk::picture_with(const std::function<bool(const Picture&)>& fits, const std::string& what)
{
    Picture last;
    const bool is_there = comes_true([&] {
        last = picture();
        return fits(last);
    });
    INFO("waited for: " << what << "\n" << messages());
    REQUIRE(is_there);
    return last;
}

Picture Desk::picture_at_rest()
{
    Picture before = picture();
    return picture_with(
        [&](const Picture& now) {
            const bool is_same = now.extent == before.extent && now.texels == before.texels;
            before = now;
            return is_same;
        },
        "two equal pictures");
}

std::string Desk::messages() const { return content(path("stderr")); }

void Desk::wait_for_message(const std::string& text, int times)
{
    const auto count = [&] {
        const std::string all = messages();
        int found = 0;
        for (size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1))
            ++found;
        return found;
    };
    const bool is_there = comes_true([&] { return count() >= times; });
    INFO("waited for the message: " << text << "\n" << messages());
    REQUIRE(is_there);
}

std::string Desk::wait_for_line(const std::string& start)
{
    std::string line;
    const bool is_there = comes_true([&] {
        const std::string all = "\n" + content(path("stdout"));
        const size_t at = all.find("\n" + start);
        const size_t end = at == std::string::npos ? at : all.find('\n', at + 1);
        if (end == std::string::npos)
            return false;
        line = all.substr(at + 1, end - at - 1);
        return true;
    });
    INFO("waited for a line: " << start << "\n" << messages());
    REQUIRE(is_there);
    return line;
}

bool Desk::is_running() const
{
    int status = 0;
    if (!has_ended_ && ::waitpid(program_, &status, WNOHANG) == program_) {
        has_ended_ = true;
        exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    return !has_ended_;
}

int Desk::wait_for_end()
{
    REQUIRE(comes_true([&] { return !is_running(); }));
    return exit_code_;
}

void Desk::edit(const std::string& file, const std::string& from, const std::string& to) const
{
    std::string text = read(file);
    const size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    write(file, text.replace(at, from.size(), to));
}

void Desk::write(const std::string& file, const std::string& text) const
{
    std::ofstream stream(path(file), std::ios::binary);
    stream << text;
    stream.close();
    REQUIRE(stream.good());
}

std::string Desk::read(const std::string& file) const { return content(path(file)); }

std::vector<double> means(const Picture& picture)
{
    std::vector<double> sums(static_cast<size_t>(picture.channels));
    for (size_t i = 0; i < picture.texels.size(); ++i)
        sums[i % sums.size()] += static_cast<double>(picture.texels[i]);
    for (double& sum : sums)
        sum /= static_cast<double>(picture.texels.size()) / static_cast<double>(sums.size());
    return sums;
}

double difference(const Picture& a, const Picture& b)
{
    if (!(a.extent == b.extent) || a.channels != b.channels)
        return 1.0;
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i)
        sum += std::abs(static_cast<double>(a.texels[i]) - static_cast<double>(b.texels[i]));
    return sum / static_cast<double>(a.texels.size());
}

} // namespace passgraph::test
