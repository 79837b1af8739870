// Progress on a terminal.
#include "tool/progress.hpp"

#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace passgraph::tool {
namespace {

double seconds_now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

Progress::Progress(const std::string& what) : is_shown_(::isatty(STDERR_FILENO) == 1), last_(seconds_now()) { show(what); }

Progress::~Progress() { show(""); }

void Progress::update(const std::string& what)
{
    const double now = seconds_now();
    if (now - last_ < 0.1)
        return;
    last_ = now;
    show(what);
}

void Progress::show(const std::string& what) const
{
    if (!is_shown_)
        return;
    fmt::print(stderr, "\r\033[K{}", what); // back to the line's start, the rest erased
    std::fflush(stderr);
}

} // namespace passgraph::tool
