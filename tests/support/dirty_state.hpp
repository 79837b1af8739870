// A host that leaves OpenGL's state in disorder.
#pragma once

#include <random>

#include <passgraph/context/context.hpp>

namespace passgraph::test {

/// Each call sets the state that draws depend on to something else, seldom to what it was: blending, masks, tests, culling,
/// scissor and viewport, logic operations, polygon modes, bound objects, pixel transfer. The objects it binds are its own.
class DirtyState {
public:
    DirtyState(GlLoader loader, unsigned seed);
    ~DirtyState(); ///< puts OpenGL's defaults back
    DirtyState(const DirtyState&) = delete;
    DirtyState& operator=(const DirtyState&) = delete;

    void operator()();

private:
    template <class Function>
    Function get(const char* name) const
    {
        return reinterpret_cast<Function>(loader_(name));
    }
    bool coin() { return random_() % 2 == 0; }
    void set_switches();
    void set_draws();
    void bind_objects(bool is_dirty);
    void restore();

    GlLoader loader_;
    std::mt19937 random_;
    unsigned buffer_ = 0;
    unsigned texture_ = 0;
    unsigned sampler_ = 0;
    unsigned vertex_array_ = 0;
    unsigned framebuffer_ = 0;
};

} // namespace passgraph::test
