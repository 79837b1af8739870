// Chooses a kind of context and lets at most one be current on a thread.
#include "passgraph/context/context.hpp"

#include <cassert>

#include <fmt/format.h>

#include "context/kinds.hpp"

namespace passgraph
{

namespace context_kinds
{

namespace
{

thread_local Context* current = nullptr;

} // namespace

void release_other_kinds(ContextKind kind)
{
    if (current && current->kind() != kind)
        current->release();
}

void before_made_current(Context& context)
{
    release_other_kinds(context.kind());
    current = &context;
}

bool after_released(const Context& context)
{
    const bool was_current = current == &context;
    if (was_current)
        current = nullptr;
    return was_current;
}

} // namespace context_kinds

namespace
{

context_kinds::Created create_unbound(ContextKind kind, const ContextOptions& options)
{
    switch (kind) {
    case ContextKind::osmesa:
        return context_kinds::create_osmesa(options);
    case ContextKind::egl:
        return context_kinds::create_egl(options);
    case ContextKind::glfw:
        return context_kinds::create_glfw(options);
    }
    assert(false);
    return {};
}

} // namespace

tl::expected<std::unique_ptr<Context>, ContextError> create_context(ContextKind kind, const ContextOptions& options)
{
    if (options.width < 1 || options.height < 1)
        return tl::unexpected(
            ContextError{fmt::format("a context of {} x {} pixels cannot be made", options.width, options.height),
                         "ask for at least 1 x 1"});
    context_kinds::Created created = create_unbound(kind, options);
    if (created && !(*created)->make_current())
        return tl::unexpected(
            ContextError{fmt::format("{}: the driver refuses to make its context current", name(kind)),
                         "is the graphics driver installed? (libgl1-mesa-dri)"});
    return created;
}

tl::expected<std::unique_ptr<Context>, ContextError> create_headless_context(const ContextOptions& options)
{
    context_kinds::Created osmesa = create_context(ContextKind::osmesa, options);
    if (osmesa)
        return osmesa;
    context_kinds::Created egl = create_context(ContextKind::egl, options);
    if (egl)
        return egl;
    return tl::unexpected(ContextError{fmt::format("{}; {}", osmesa.error().message, egl.error().message),
                                       fmt::format("{}; or {}", osmesa.error().hint, egl.error().hint)});
}

std::string_view name(ContextKind kind)
{
    switch (kind) {
    case ContextKind::osmesa:
        return "osmesa";
    case ContextKind::egl:
        return "egl";
    case ContextKind::glfw:
        return "glfw";
    }
    assert(false);
    return {};
}

} // namespace passgraph
