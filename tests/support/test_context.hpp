// The one headless context of a test program.
#pragma once

#include <passgraph/context/context.hpp>

namespace passgraph::test {

/// Current on return. Having no kind of context is an error, not a skip: the test fails with the reason.
Context& test_context();

} // namespace passgraph::test
