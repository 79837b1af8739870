// What the three kinds of context share: how each is made, and who is current.
#pragma once

#include <array>
#include <utility>

#include "passgraph/context/context.hpp"

namespace passgraph::context_kinds
{

using Created = tl::expected<std::unique_ptr<Context>, ContextError>;

/// The core-profile versions to ask for, best first. Mesa's software drivers refuse 4.6 (GLX with an X error).
inline constexpr std::array<std::pair<int, int>, 4> kVersions = {{{4, 5}, {4, 3}, {4, 1}, {3, 3}}};

/// Each makes a context that is not yet current.
Created create_osmesa(const ContextOptions& options);
Created create_egl(const ContextOptions& options);
Created create_glfw(const ContextOptions& options);

/// Releases the calling thread's current context unless it is of `kind`.
///
/// Mesa keeps one current context per thread for all kinds: making a second kind current on top of the first draws into
/// the first (OSMesa) or ends in an X error (EGL and GLX).
void release_other_kinds(ContextKind kind);

/// Releases other kinds and remembers `context` as the calling thread's current one.
void before_made_current(Context& context);

/// Forgets `context` if the calling thread holds it as current; true when it did.
bool after_released(const Context& context);

} // namespace passgraph::context_kinds
