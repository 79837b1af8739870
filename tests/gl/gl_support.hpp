// Hand-written plans, a context, and a loader that can hide, count and spoil GL functions.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

#include <passgraph/context/context.hpp>
#include <passgraph/core/plan.hpp>
#include <passgraph/gl/renderer.hpp>

#include "support/catch.hpp"

namespace passgraph::test {

/// The one headless context of this program, current. Fails the test when the machine has none.
GlLoader test_loader();

/// A GL function of the test's context.
template <class Function> Function gl_function(const char* name)
{
    return reinterpret_cast<Function>(test_loader()(name));
}

/// What the spying loader does; `reset` before use.
struct Spy {
    std::set<std::string> hidden;              ///< the loader does not know these
    std::map<std::string, std::int64_t> calls; ///< of the functions that are counted
    std::int64_t objects_alive = 0;            ///< created minus deleted, through this loader
    GLint version = 0;                         ///< 33: what GL_MAJOR_VERSION and GL_MINOR_VERSION say; 0: the truth
    GLenum framebuffer_status = 0;             ///< what glCheckFramebufferStatus says; 0: the truth
    GLenum next_error = GL_NO_ERROR;           ///< what glGetError says after the next glTexImage2D
    bool spoils_draws = false;                 ///< each glDrawArrays is an invalid call
};
Spy& spy();
Spy& reset_spy();
GlLoader spying_loader();

/// A renderer of the plan; the test fails with the errors' text.
Renderer make_renderer(Plan plan, RendererOptions options = {});
void require_ok(const Result<void>& result);
/// Renders one frame and reads an output.
Picture render_and_read(Renderer& renderer, const std::string& output = "color", const Frame& frame = {});
/// The codes of all errors.
template <class T> std::vector<std::string> codes(const Result<T>& result)
{
    std::vector<std::string> found;
    if (!result)
        for (const Error& error : result.error())
            found.push_back(error.code);
    return found;
}

/// Writes a plan by hand.
struct PlanBuilder {
    Plan plan;

    explicit PlanBuilder(Extent extent) { plan.extent = extent; }
    int slot(Format format, const std::string& image);
    int slot(Format format, const std::string& image, Extent extent);
    int import(Plan::Import::Kind kind, const std::string& name, Signal signal, Extent extent = {});
    /// A full-screen step. `body` follows `in vec2 uv;` and starts at line 1 of source 0, "<name>.glsl".
    Plan::Step& draw(const std::string& name, const std::string& body, const std::vector<int>& targets);
    Plan::Step& geometry(const std::string& name, const std::string& body, const std::vector<int>& targets, int depth);
    void output(const std::string& name, int slot, Signal signal, const std::string& codec);
    void output_import(const std::string& name, int import);
};

Plan::Read read_slot(int slot, const std::string& sampler);
/// Whole texels of a slot, by `imageLoad`; `loads_images` lets a step's fragment stage declare images.
Plan::Read load_slot(int slot, const std::string& image);
void loads_images(Plan::Step& step);
Plan::Read read_import(int import, const std::string& sampler, bool has_levels = false);

/// One step that fills a picture with a color: "color", rgba32f radiance.
Plan constant_plan(Extent extent, const std::string& color = "vec4(0.25, 0.5, 0.75, 1.0)");

} // namespace passgraph::test
