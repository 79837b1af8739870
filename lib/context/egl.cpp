// Contexts without any surface: EGL, opened at run time, on a GPU or on Mesa's software driver.
//
// The environment variable PASSGRAPH_EGL names another library to open instead.
#include <cstdint>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "context/kinds.hpp"
#include "context/shared_library.hpp"

namespace passgraph::context_kinds
{

namespace
{

// From EGL/egl.h and EGL/eglext.h.
constexpr int kNone = 0x3038;
constexpr unsigned kPlatformSurfacelessMesa = 0x31DD;
constexpr int kExtensions = 0x3055;
constexpr unsigned kOpenGlApi = 0x30A2;
constexpr int kSurfaceType = 0x3033;
constexpr int kRenderableType = 0x3040;
constexpr int kOpenGlBit = 0x0008;
constexpr int kMajorVersion = 0x3098;
constexpr int kMinorVersion = 0x30FB;
constexpr int kProfileMask = 0x30FD;
constexpr int kCoreProfileBit = 1;

struct Egl {
    void* (*get_proc_address)(const char* name);
    void* (*get_display)(void* native);
    unsigned (*initialize)(void* display, int32_t* major, int32_t* minor);
    unsigned (*terminate)(void* display);
    const char* (*query_string)(void* display, int32_t name);
    unsigned (*bind_api)(unsigned api);
    unsigned (*choose_config)(void* display, const int32_t* attributes, void** configs, int32_t size, int32_t* count);
    void* (*create_context)(void* display, void* config, void* shared, const int32_t* attributes);
    unsigned (*destroy_context)(void* display, void* context);
    unsigned (*make_current)(void* display, void* draw, void* read, void* context);
};

/// The one initialized display; the last context that goes terminates it.
struct Display {
    Egl api{};
    void* handle = nullptr;
    int users = 0;
    std::mutex mutex{};
};

Display& display()
{
    static Display the_display;
    return the_display;
}

ContextError lack(std::string_view reason)
{
    return {fmt::format("egl: {}", reason), "install libegl1 and libegl-mesa0 (Debian), or use another --context"};
}

tl::expected<Egl, ContextError> load_egl()
{
    const auto library = SharedLibrary::open("PASSGRAPH_EGL", {"libEGL.so.1", "libEGL.so"});
    if (!library)
        return tl::unexpected(lack(library.error()));
    Egl api{};
    if (!library->load(api.get_proc_address, "eglGetProcAddress") || !library->load(api.get_display, "eglGetDisplay") ||
        !library->load(api.initialize, "eglInitialize") || !library->load(api.terminate, "eglTerminate") ||
        !library->load(api.query_string, "eglQueryString") || !library->load(api.bind_api, "eglBindAPI") ||
        !library->load(api.choose_config, "eglChooseConfig") ||
        !library->load(api.create_context, "eglCreateContext") ||
        !library->load(api.destroy_context, "eglDestroyContext") || !library->load(api.make_current, "eglMakeCurrent"))
        return tl::unexpected(lack("the library is too old: it lacks functions of EGL 1.4"));
    return api;
}

bool has_extension(const Egl& api, void* of_display, std::string_view name)
{
    const char* const found = api.query_string(of_display, kExtensions);
    return found && fmt::format(" {} ", found).find(fmt::format(" {} ", name)) != std::string::npos;
}

/// An initialized display that needs no window system, else the machine's default one.
void* open_display(const Egl& api)
{
    using GetPlatformDisplay = void* (*)(unsigned platform, void* native, const int32_t* attributes);
    const auto get_platform_display =
        reinterpret_cast<GetPlatformDisplay>(api.get_proc_address("eglGetPlatformDisplayEXT"));
    int32_t major = 0;
    int32_t minor = 0;
    if (get_platform_display && has_extension(api, nullptr, "EGL_MESA_platform_surfaceless"))
        if (void* const found = get_platform_display(kPlatformSurfacelessMesa, nullptr, nullptr))
            if (api.initialize(found, &major, &minor))
                return found;
    void* const found = api.get_display(nullptr);
    return found && api.initialize(found, &major, &minor) ? found : nullptr;
}

/// Counts one more user of the display, opening it for the first; the lock is held.
tl::expected<void, ContextError> acquire_display()
{
    Display& shared = display();
    if (shared.users == 0) {
        const auto api = load_egl();
        if (!api)
            return tl::unexpected(api.error());
        shared.api = *api;
        shared.handle = open_display(*api);
        if (!shared.handle)
            return tl::unexpected(lack("no display can be opened, neither without a surface nor the default one"));
    }
    ++shared.users;
    return {};
}

/// Counts one user less; the lock is held.
void release_display()
{
    Display& shared = display();
    if (--shared.users == 0)
        shared.api.terminate(std::exchange(shared.handle, nullptr));
}

void* load_gl(const char* function)
{
    return display().api.get_proc_address(function);
}

class EglContext final : public Context
{
public:
    explicit EglContext(void* context) : context_(context) {}
    ~EglContext() override
    {
        release();
        const std::scoped_lock lock(display().mutex);
        display().api.destroy_context(display().handle, context_);
        release_display();
    }

    bool make_current() override
    {
        before_made_current(*this);
        const Egl& api = display().api;
        const bool is_done = api.bind_api(kOpenGlApi) && api.make_current(display().handle, nullptr, nullptr, context_);
        if (!is_done)
            release(); // a refused context must not leave the one before behind unnoticed
        return is_done;
    }
    void release() override
    {
        if (after_released(*this))
            display().api.make_current(display().handle, nullptr, nullptr, nullptr);
    }
    GlLoader loader() const override { return load_gl; }
    ContextKind kind() const override { return ContextKind::egl; }

private:
    void* context_;
};

/// The context of the best version, or nothing and `reason`.
void* create_best(const Egl& api, void* on_display, std::string& reason)
{
    if (!has_extension(api, on_display, "EGL_KHR_surfaceless_context")) {
        reason = "the driver needs a surface: it lacks EGL_KHR_surfaceless_context";
        return nullptr;
    }
    // Without a surface type the default would ask for windows, which a surfaceless display has none of.
    const std::array<int32_t, 5> wanted = {kSurfaceType, 0, kRenderableType, kOpenGlBit, kNone};
    void* config = nullptr;
    int32_t count = 0;
    if (!api.bind_api(kOpenGlApi) || !api.choose_config(on_display, wanted.data(), &config, 1, &count) || count < 1) {
        reason = "the driver has no desktop OpenGL";
        return nullptr;
    }
    for (const auto& [major, minor] : kVersions) {
        const std::array<int32_t, 7> attributes = {kMajorVersion, major,           kMinorVersion, minor,
                                                   kProfileMask,  kCoreProfileBit, kNone};
        if (void* const context = api.create_context(on_display, config, nullptr, attributes.data()))
            return context;
    }
    reason = "no OpenGL 3.3 core context can be made";
    return nullptr;
}

} // namespace

Created create_egl(const ContextOptions&)
{
    const std::scoped_lock lock(display().mutex);
    if (const auto acquired = acquire_display(); !acquired)
        return tl::unexpected(acquired.error());
    std::string reason;
    void* const context = create_best(display().api, display().handle, reason);
    if (!context) {
        release_display();
        return tl::unexpected(lack(reason));
    }
    return std::make_unique<EglContext>(context);
}

} // namespace passgraph::context_kinds
