// A current OpenGL context, whatever made it: OSMesa, EGL without a surface, or a GLFW window.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace passgraph {

enum class ContextKind { osmesa, egl, glfw };

/// Looks up a GL function by name; nullptr when the context has none.
using GlLoader = void* (*)(const char* name);

/// Why no context could be made: what the machine lacks, and what to install.
struct ContextError {
    std::string message;
    std::string hint;
};

/// Owns one OpenGL core-profile context (3.3 or newer) and knows how to make it current.
///
/// OSMesa and EGL are opened with dlopen, so neither needs to be there; the environment variables PASSGRAPH_OSMESA and
/// PASSGRAPH_EGL name other libraries to open instead of the system's. The kinds share Mesa's one current-context slot:
/// `make_current` therefore releases a current context of another kind first.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes this context current on the calling thread. False when the driver refuses.
    virtual bool make_current() = 0;
    /// Leaves no context of this kind current.
    virtual void release() = 0;
    virtual GlLoader loader() const = 0;
    virtual ContextKind kind() const = 0;

protected:
    Context() = default;
};

struct ContextOptions {
    int width = 64;           ///< of the window or the unused default buffer, in pixels
    int height = 64;
    bool visible = false;     ///< GLFW only: show the window
    std::string title = "passgraph";
};

/// Makes a context of one kind and makes it current.
tl::expected<std::unique_ptr<Context>, ContextError> create_context(ContextKind kind, const ContextOptions& options = {});

/// Makes a context for headless work and makes it current: OSMesa, or EGL where OSMesa is absent.
/// The error names both reasons.
tl::expected<std::unique_ptr<Context>, ContextError> create_headless_context(const ContextOptions& options = {});

std::string_view name(ContextKind kind);

} // namespace passgraph
