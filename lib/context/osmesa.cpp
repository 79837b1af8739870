// Contexts that draw into memory: Mesa's off-screen library, opened at run time.
//
// The environment variable PASSGRAPH_OSMESA names another library to open instead.
#include <vector>

#include <fmt/format.h>

#include "context/kinds.hpp"
#include "context/shared_library.hpp"

namespace passgraph::context_kinds
{

namespace
{

// From GL/osmesa.h, which would declare the functions for linking.
constexpr int kRgba = 0x1908;
constexpr int kUnsignedByte = 0x1401;
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kStencilBits = 0x31;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

struct OsMesa {
    void* (*create)(const int* attributes, void* shared);
    void (*destroy)(void* context);
    unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height);
    void* (*get_proc_address)(const char* name);
};

ContextError lack(std::string_view reason)
{
    return {fmt::format("osmesa: {}", reason), "install libosmesa6 (Debian), or use another --context"};
}

tl::expected<OsMesa, ContextError> load_osmesa()
{
    const auto library = SharedLibrary::open("PASSGRAPH_OSMESA", {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
    if (!library)
        return tl::unexpected(lack(library.error()));
    OsMesa api{};
    if (!library->load(api.create, "OSMesaCreateContextAttribs") ||
        !library->load(api.destroy, "OSMesaDestroyContext") || !library->load(api.make_current, "OSMesaMakeCurrent") ||
        !library->load(api.get_proc_address, "OSMesaGetProcAddress"))
        return tl::unexpected(lack("the library is too old: it lacks OSMesaCreateContextAttribs"));
    return api;
}

/// The loader is a plain function, so what it calls is kept here.
void* (*loader_function)(const char*) = nullptr;

void* load_gl(const char* function)
{
    return loader_function(function);
}

class OsMesaContext final : public Context
{
public:
    OsMesaContext(const OsMesa& api, void* context, const ContextOptions& options)
        : api_(api), context_(context), width_(options.width), height_(options.height),
          buffer_(4 * static_cast<size_t>(options.width) * static_cast<size_t>(options.height))
    {
    }
    ~OsMesaContext() override
    {
        release();
        api_.destroy(context_);
    }

    bool make_current() override
    {
        before_made_current(*this);
        const bool is_done = api_.make_current(context_, buffer_.data(), kUnsignedByte, width_, height_) != 0;
        if (!is_done)
            release(); // a refused context must not leave the one before behind unnoticed
        return is_done;
    }
    void release() override
    {
        if (after_released(*this))
            api_.make_current(nullptr, nullptr, kUnsignedByte, 0, 0);
    }
    GlLoader loader() const override { return load_gl; }
    ContextKind kind() const override { return ContextKind::osmesa; }

private:
    OsMesa api_;
    void* context_;
    int width_;
    int height_;
    std::vector<unsigned char> buffer_;
};

} // namespace

Created create_osmesa(const ContextOptions& options)
{
    const auto api = load_osmesa();
    if (!api)
        return tl::unexpected(api.error());
    loader_function = api->get_proc_address;
    for (const auto& [major, minor] : kVersions) {
        const std::array<int, 13> attributes = {kFormat,  kRgba,        kDepthBits,    0,     kStencilBits,  0,
                                                kProfile, kCoreProfile, kMajorVersion, major, kMinorVersion, minor,
                                                0};
        if (void* const context = api->create(attributes.data(), nullptr))
            return std::make_unique<OsMesaContext>(*api, context, options);
    }
    return tl::unexpected(lack("no OpenGL 3.3 core context can be made"));
}

} // namespace passgraph::context_kinds
