// Contexts of each kind: made, made current, told apart, released; and what is said when one cannot be made.
#include "support/catch.hpp"

#include <cstdlib>
#include <string>
#include <utility>

#include "passgraph/context/context.hpp"

using passgraph::Context;
using passgraph::ContextKind;

namespace
{

constexpr unsigned kVersion = 0x1F02;
constexpr unsigned kMajorVersion = 0x821B;
constexpr unsigned kMinorVersion = 0x821C;
constexpr unsigned kProfileMask = 0x9126;
constexpr int kCoreProfileBit = 1;

template <class Function> Function* gl(const Context& context, const char* name)
{
    auto* const function = reinterpret_cast<Function*>(context.loader()(name));
    REQUIRE(function != nullptr);
    return function;
}

int get_integer(const Context& context, unsigned what)
{
    int value = -1;
    gl<void(unsigned, int*)>(context, "glGetIntegerv")(what, &value);
    return value;
}

unsigned new_texture(const Context& context)
{
    unsigned texture = 0;
    gl<void(int, unsigned*)>(context, "glGenTextures")(1, &texture);
    return texture;
}

/// An environment variable for the length of a test.
class Environment
{
public:
    Environment(const char* name, const char* value) : name_(name)
    {
        if (const char* const old = std::getenv(name))
            old_ = old;
        value ? ::setenv(name, value, 1) : ::unsetenv(name);
    }
    ~Environment() { old_.empty() ? ::unsetenv(name_) : ::setenv(name_, old_.c_str(), 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* name_;
    std::string old_;
};

std::unique_ptr<Context> make(ContextKind kind)
{
    auto context = passgraph::create_context(kind);
    INFO((context ? std::string() : context.error().message));
    REQUIRE(context.has_value());
    return std::move(*context);
}

void require_core_profile(const Context& context)
{
    const auto* version = gl<const unsigned char*(unsigned)>(context, "glGetString")(kVersion);
    REQUIRE(version != nullptr);
    const int major = get_integer(context, kMajorVersion);
    const int minor = get_integer(context, kMinorVersion);
    INFO(reinterpret_cast<const char*>(version));
    CHECK(10 * major + minor >= 33);
    CHECK((get_integer(context, kProfileMask) & kCoreProfileBit) != 0);
}

bool is_any_current(const Context& context)
{
    // Without a current context Mesa's dispatch does nothing, so the value stays.
    return get_integer(context, kMajorVersion) > 0;
}

} // namespace

TEST_CASE("a context is a current core profile of OpenGL 3.3 or newer", "[context]")
{
    const ContextKind kind = GENERATE(ContextKind::osmesa, ContextKind::egl);
    const auto context = make(kind);
    CHECK(context->kind() == kind);
    require_core_profile(*context);
}

TEST_CASE("Mesa's drivers give the version 4.5 that was asked for first", "[context]")
{
    const auto context = make(ContextKind::osmesa);
    CHECK(10 * get_integer(*context, kMajorVersion) + get_integer(*context, kMinorVersion) >= 43);
}

TEST_CASE("contexts of two kinds are told apart when they take turns", "[context]")
{
    const auto osmesa = make(ContextKind::osmesa);
    CHECK(new_texture(*osmesa) == 1);
    const auto egl = make(ContextKind::egl);
    CHECK(new_texture(*egl) == 1); // a silent mix-up continues with 2
    CHECK(new_texture(*egl) == 2);
    REQUIRE(osmesa->make_current());
    CHECK(new_texture(*osmesa) == 2);
    REQUIRE(egl->make_current());
    CHECK(new_texture(*egl) == 3);
    REQUIRE(osmesa->make_current());
    CHECK(new_texture(*osmesa) == 3);
}

TEST_CASE("several contexts of one kind live at once", "[context]")
{
    const ContextKind kind = GENERATE(ContextKind::osmesa, ContextKind::egl);
    const auto first = make(kind);
    CHECK(new_texture(*first) == 1);
    auto second = make(kind);
    CHECK(new_texture(*second) == 1);
    REQUIRE(first->make_current());
    CHECK(new_texture(*first) == 2);
    second.reset(); // not current: the first one stays so, and EGL's display stays open
    CHECK(new_texture(*first) == 3);
    require_core_profile(*first);
}

TEST_CASE("a released context is current no more, and can be again", "[context]")
{
    const ContextKind kind = GENERATE(ContextKind::osmesa, ContextKind::egl);
    const auto context = make(kind);
    REQUIRE(is_any_current(*context));
    context->release();
    CHECK_FALSE(is_any_current(*context));
    context->release(); // twice is harmless
    REQUIRE(context->make_current());
    CHECK(is_any_current(*context));
}

TEST_CASE("releasing a context that is not current leaves the current one alone", "[context]")
{
    const auto osmesa = make(ContextKind::osmesa);
    const auto egl = make(ContextKind::egl);
    osmesa->release();
    CHECK(is_any_current(*egl));
    CHECK(new_texture(*egl) == 1);
}

TEST_CASE("a destroyed context leaves nothing current", "[context]")
{
    const ContextKind kind = GENERATE(ContextKind::osmesa, ContextKind::egl);
    const ContextKind other = kind == ContextKind::osmesa ? ContextKind::egl : ContextKind::osmesa;
    const auto witness = make(other);
    make(kind).reset();
    CHECK_FALSE(is_any_current(*witness));
    REQUIRE(witness->make_current());
    CHECK(is_any_current(*witness));
}

TEST_CASE("EGL can be opened again after its last context has gone", "[context][egl]")
{
    for (int i = 0; i < 3; ++i)
        CHECK(new_texture(*make(ContextKind::egl)) == 1);
}

TEST_CASE("an unknown function has no address in OSMesa", "[context]")
{
    const auto context = make(ContextKind::osmesa);
    CHECK(context->loader()("glNoSuchFunctionOfAnyVersion") == nullptr);
}

TEST_CASE("a headless context is OSMesa where it is installed", "[context]")
{
    const auto context = passgraph::create_headless_context();
    REQUIRE(context.has_value());
    CHECK((*context)->kind() == ContextKind::osmesa);
}

TEST_CASE("a headless context is EGL where OSMesa is absent", "[context]")
{
    const Environment absent("PASSGRAPH_OSMESA", "libNoSuchOSMesa.so.0");
    const auto context = passgraph::create_headless_context();
    REQUIRE(context.has_value());
    CHECK((*context)->kind() == ContextKind::egl);
    require_core_profile(**context);
}

TEST_CASE("without OSMesa and EGL the error names both and what to install", "[context]")
{
    const Environment no_osmesa("PASSGRAPH_OSMESA", "libNoSuchOSMesa.so.0");
    const Environment no_egl("PASSGRAPH_EGL", "libNoSuchEGL.so.0");
    const auto context = passgraph::create_headless_context();
    REQUIRE_FALSE(context.has_value());
    CHECK_THAT(context.error().message,
               Catch::Contains("libNoSuchOSMesa.so.0") && Catch::Contains("libNoSuchEGL.so.0"));
    CHECK_THAT(context.error().hint, Catch::Contains("libosmesa6") && Catch::Contains("libegl1"));
}

TEST_CASE("a library that is not the one expected is an error, not a crash", "[context]")
{
    const Environment osmesa("PASSGRAPH_OSMESA", "libc.so.6");
    const Environment egl("PASSGRAPH_EGL", "libc.so.6");
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
        const auto context = passgraph::create_context(kind);
        REQUIRE_FALSE(context.has_value());
        CHECK_THAT(context.error().message, Catch::Contains("lacks"));
    }
}

TEST_CASE("a failed attempt leaves the current context as it was", "[context]")
{
    const auto egl = make(ContextKind::egl);
    const Environment absent("PASSGRAPH_OSMESA", "libNoSuchOSMesa.so.0");
    CHECK_FALSE(passgraph::create_context(ContextKind::osmesa).has_value());
    CHECK(is_any_current(*egl));
}

TEST_CASE("a context without pixels is refused", "[context]")
{
    const ContextKind kind = GENERATE(ContextKind::osmesa, ContextKind::egl, ContextKind::glfw);
    const auto context = passgraph::create_context(kind, {.width = 0, .height = 8});
    REQUIRE_FALSE(context.has_value());
    CHECK_THAT(context.error().message, Catch::Contains("0 x 8"));
}

TEST_CASE("without a display GLFW says how to get one", "[context][glfw]")
{
    const Environment no_display("DISPLAY", nullptr);
    const Environment no_wayland("WAYLAND_DISPLAY", nullptr);
    const auto context = passgraph::create_context(ContextKind::glfw);
    REQUIRE_FALSE(context.has_value());
    CHECK_THAT(context.error().message, Catch::StartsWith("glfw: "));
    CHECK_THAT(context.error().hint, Catch::Contains("Xvfb") && Catch::Contains("--context osmesa"));
}

TEST_CASE("a window's context takes turns with the other kinds", "[context][glfw]")
{
    if (!std::getenv("DISPLAY")) {
        WARN("there is no DISPLAY: only GLFW's error is tested");
        return;
    }
    const auto osmesa = make(ContextKind::osmesa);
    CHECK(new_texture(*osmesa) == 1);
    const auto window = make(ContextKind::glfw);
    require_core_profile(*window);
    CHECK(new_texture(*window) == 1);
    const auto egl = make(ContextKind::egl);
    CHECK(new_texture(*egl) == 1);
    REQUIRE(window->make_current());
    CHECK(new_texture(*window) == 2);
    REQUIRE(osmesa->make_current());
    CHECK(new_texture(*osmesa) == 2);
    auto second = make(ContextKind::glfw);
    CHECK(new_texture(*second) == 1);
    second.reset();
    CHECK_FALSE(is_any_current(*osmesa)); // GLFW's own loader has no answer without a context
    REQUIRE(window->make_current());
    CHECK(new_texture(*window) == 3);
}

TEST_CASE("each kind has the name of its command-line option", "[context]")
{
    CHECK(passgraph::name(ContextKind::osmesa) == "osmesa");
    CHECK(passgraph::name(ContextKind::egl) == "egl");
    CHECK(passgraph::name(ContextKind::glfw) == "glfw");
}
