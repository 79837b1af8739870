// The one headless context of a test program.
#include "support/test_context.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace passgraph::test {

Context& test_context()
{
    static const std::unique_ptr<Context> context = [] {
        auto made = create_headless_context();
        if (!made) {
            std::fprintf(stderr, "no context: %s\n  hint: %s\n", made.error().message.c_str(),
                         made.error().hint.c_str());
            std::exit(3);
        }
        return std::move(*made);
    }();
    context->make_current();
    return *context;
}

} // namespace passgraph::test
