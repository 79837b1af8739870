// One full-screen draw per image, with a program per signal and codec.
#include <passgraph/gl/presenter.hpp>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "gl/programs.hpp"
#include "gl/read_back.hpp"

namespace passgraph {
namespace {

constexpr const char* kSamplers[] = {"passgraph_image_0", "passgraph_image_1", "passgraph_image_2", "passgraph_image_3"};

constexpr const char* kVertex = R"(#version 330 core
out vec2 uv;
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    uv = corner * 0.5 + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// GLSL of three numbers on the signal's scale, from its value `v`.
std::string_view scale_of(Signal signal)
{
    switch (signal) {
    case Signal::radiance:
    case Signal::color: return "v / (1.0 + v)";
    case Signal::radiance_alpha: return "v.rgb / (1.0 + v.rgb)";
    case Signal::display_alpha: return "v.rgb";
    case Signal::normal: return "v * 0.5 + 0.5";
    case Signal::depth: return "vec3(v > 0.0 ? 1.0 / v : 3.4e38)";
    case Signal::atlas_uv:
    case Signal::reflectance: return "vec3(v, 0.0)";
    case Signal::velocity: return "vec3(v / 64.0 + 0.5, 0.5)";
    case Signal::exposure: return "vec3(v / (1.0 + v))";
    case Signal::mask: return "vec3(v)";
    case Signal::display:
    case Signal::albedo:
    case Signal::material:
    case Signal::position: return "v";
    }
    return "vec3(v)";
}

/// What is linear in light has to be encoded for a display.
bool is_linear(Signal signal)
{
    return signal == Signal::radiance || signal == Signal::radiance_alpha || signal == Signal::albedo || signal == Signal::color;
}

/// `vec4(texture(passgraph_image_0, uv).rg, texture(passgraph_image_1, uv).a, 0.0)`: the codes, wherever they stand.
std::string gathered_codes(const std::vector<StoredCodes>& codes)
{
    std::string text = "vec4(";
    size_t count = 0;
    for (size_t i = 0; i < codes.size(); ++i) {
        text += fmt::format("{}texture({}, uv).{}", i == 0 ? "" : ", ", kSamplers[i], codes[i].channels);
        count += codes[i].channels.size();
    }
    for (; count < 4; ++count)
        text += count == 3 ? ", 1.0" : ", 0.0";
    return text + ")";
}

std::string fragment_of(const ShownImage& image)
{
    std::string text = "#version 330 core\nuniform vec3 low;\nuniform vec3 high;\nin vec2 uv;\nout vec4 color;\n";
    for (size_t i = 0; i < image.codes.size(); ++i)
        text += fmt::format("uniform sampler2D {};\n", kSamplers[i]);
    text += glsl_codec_functions();
    // A stored distance is on the scale already: 1 / (1 / z).
    text += "float passgraph_depth_of(float distance) { return distance > 0.0 ? 1.0 / distance : 0.0; }\n";
    text += fmt::format("void main()\n{{\n    vec4 texel = {};\n", gathered_codes(image.codes));
    text += fmt::format("    {} v = {};\n", glsl_type(info(image.signal).components), glsl_decode_call(image.signal, image.codec, "texel"));
    text += fmt::format("    vec3 c = clamp(({} - low) / (high - low), 0.0, 1.0);\n", scale_of(image.signal));
    if (is_linear(image.signal)) // IEC 61966-2-1
        text += "    c = mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));\n";
    return text + "    color = vec4(c, 1.0);\n}\n";
}

Value value_of(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

constexpr GLfloat kRim[] = {0.035f, 0.035f, 0.04f, 1.0f}; // beside the image

} // namespace

class Presenter::Impl {
public:
    explicit Impl(gl::Driver&& driver) : driver_(std::move(driver)), state_(driver_), samplers_(driver_) {}

    Result<void> show(const ShownImage& image, Extent window);
    Result<void> clear();
    Result<HostTexture> keep(size_t index, const ShownImage& image, Extent extent);
    Result<Picture> read(const ShownImage& image);

private:
    struct Target {
        gl::TextureObject texture;
        gl::FramebufferObject framebuffer;
        Extent extent;
    };

    Result<gl::Program*> program_of(const ShownImage& image);
    void begin(gl::Upload& upload);
    void fit(gl::Upload& upload, Target& target, Extent extent);
    Result<void> draw(gl::Upload& upload, const ShownImage& image, const Place& place);

    gl::Driver driver_; ///< before all objects, which are deleted through it
    gl::State state_;
    gl::Samplers samplers_;
    gl::VertexArrayObject no_vertices_;
    std::optional<gl::Reader> reader_;
    std::map<std::string, gl::Program> programs_; ///< by the fragment stage's text
    std::map<size_t, Target> kept_;
    Target whole_; ///< what `read` draws into
};

void Presenter::Impl::begin(gl::Upload& upload)
{
    state_.reset();
    if (!no_vertices_)
        no_vertices_ = gl::VertexArrayObject(driver_);
    if (!reader_)
        reader_.emplace(upload);
}

Result<gl::Program*> Presenter::Impl::program_of(const ShownImage& image)
{
    assert(!image.codes.empty() && image.codes.size() <= std::size(kSamplers));
    Plan::Step step;
    step.fragment = fragment_of(image);
    gl::Program& known = programs_[step.fragment];
    if (known.linked)
        return &known;
    step.name = fmt::format("a view of {}", info(image.signal).name);
    for (size_t i = 0; i < image.codes.size(); ++i)
        step.reads.push_back({.sampler = kSamplers[i], .image = "image"});
    const auto uniform = [&](std::string name) {
        step.uniforms.push_back({.name = name, .place = name, .type = ParamType::vec3, .value = {}});
    };
    uniform("low");
    uniform("high");
    step.vertex = kVertex;
    Result<gl::Program> made = gl::create_program(driver_, state_, step);
    if (!made)
        return tl::unexpected(made.error());
    known = std::move(*made);
    return &known;
}

Result<void> Presenter::Impl::draw(gl::Upload& upload, const ShownImage& image, const Place& place)
{
    const Result<gl::Program*> program = program_of(image);
    if (!program)
        return tl::unexpected(program.error());
    const gl::Functions& gl = driver_.gl;
    state_.depth(gl::State::Depth::unused);
    state_.cull_back_faces(false);
    state_.encodes_srgb(false);
    gl.Viewport(place.x, place.y, place.extent.width, place.extent.height);
    state_.use_program((*program)->id());
    state_.vertex_array(no_vertices_.id());
    // Neighbours of packed codes, and of depths at an edge, have no mean.
    const bool blends = image.extent() != place.extent && image.codec.packing == Packing::plain && image.signal != Signal::depth;
    const GLuint sampler = samplers_.get(blends ? Filter::linear : Filter::nearest, AddressMode::clamp, AddressMode::clamp, false);
    for (size_t i = 0; i < image.codes.size(); ++i)
        if (const int unit = (*program)->read_units[i]; unit >= 0) {
            state_.texture(unit, GL_TEXTURE_2D, image.codes[i].texture.id);
            state_.sampler(unit, sampler);
        }
    (*program)->uniforms[0].value = value_of(image.low);
    (*program)->uniforms[1].value = value_of(image.high);
    gl::send_uniforms(gl, **program);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    for (size_t i = 0; i < image.codes.size(); ++i) // a user interface draws next, and may not know of samplers
        gl.BindSampler(static_cast<GLuint>(i), 0);
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Result<void> Presenter::Impl::show(const ShownImage& image, Extent window)
{
    gl::ErrorWatch watch(driver_);
    gl::Upload upload{driver_, state_, watch};
    begin(upload);
    state_.draw_framebuffer(0);
    const Place place = place_of(image.extent(), window);
    if (place.extent != window)
        driver_.gl.ClearBufferfv(GL_COLOR, 0, kRim);
    return draw(upload, image, place);
}

Result<void> Presenter::Impl::clear()
{
    gl::ErrorWatch watch(driver_);
    state_.reset();
    state_.draw_framebuffer(0);
    driver_.gl.ClearBufferfv(GL_COLOR, 0, kRim);
    if (Errors errors = watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

void Presenter::Impl::fit(gl::Upload& upload, Target& target, Extent extent)
{
    if (target.texture && target.extent == extent)
        return;
    target.texture = gl::create_target(upload, Format::rgba8, extent);
    target.framebuffer = gl::FramebufferObject(driver_);
    target.extent = extent;
    state_.draw_framebuffer(target.framebuffer.id());
    driver_.gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.id(), 0);
    constexpr GLenum kFirst = GL_COLOR_ATTACHMENT0;
    driver_.gl.DrawBuffers(1, &kFirst);
}

Result<HostTexture> Presenter::Impl::keep(size_t index, const ShownImage& image, Extent extent)
{
    gl::ErrorWatch watch(driver_);
    gl::Upload upload{driver_, state_, watch};
    begin(upload);
    Target& target = kept_[index];
    fit(upload, target, extent);
    state_.draw_framebuffer(target.framebuffer.id());
    const Result<void> drawn = draw(upload, image, {0, 0, extent});
    state_.draw_framebuffer(0);
    if (!drawn)
        return tl::unexpected(drawn.error());
    return HostTexture{target.texture.id(), extent};
}

Result<Picture> Presenter::Impl::read(const ShownImage& image)
{
    gl::ErrorWatch watch(driver_);
    gl::Upload upload{driver_, state_, watch};
    begin(upload);
    const Extent extent = image.extent();
    fit(upload, whole_, extent);
    state_.draw_framebuffer(whole_.framebuffer.id());
    if (const Result<void> drawn = draw(upload, image, {0, 0, extent}); !drawn)
        return tl::unexpected(drawn.error());
    const Result<Picture> raw = reader_->read(upload, whole_.texture.id(), Format::rgba8, {0, 0, extent});
    driver_.gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!raw)
        return raw;
    return decode_texels(*raw, Signal::display, *find_codec(Signal::display, "rgba8"));
}

Presenter::Place Presenter::place_of(Extent image, Extent window)
{
    if (image == window || image.width < 1 || image.height < 1)
        return {0, 0, window};
    const double scale = std::min(static_cast<double>(window.width) / image.width, static_cast<double>(window.height) / image.height);
    const auto side = [&](int texels, int most) { return std::clamp(static_cast<int>(texels * scale + 0.5), 1, std::max(most, 1)); };
    const Extent extent{side(image.width, window.width), side(image.height, window.height)};
    return {(window.width - extent.width) / 2, (window.height - extent.height) / 2, extent};
}

Presenter::Presenter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Presenter::Presenter(Presenter&&) noexcept = default;
Presenter& Presenter::operator=(Presenter&&) noexcept = default;
Presenter::~Presenter() = default;

Result<Presenter> Presenter::create(GlLoader loader)
{
    Result<gl::Driver> driver = gl::create_driver(loader);
    if (!driver)
        return tl::unexpected(std::move(driver.error()));
    return Presenter(std::make_unique<Impl>(std::move(*driver)));
}

Result<void> Presenter::show(const ShownImage& image, Extent window)
{
    return impl_->show(image, window);
}
Result<void> Presenter::clear()
{
    return impl_->clear();
}
Result<HostTexture> Presenter::keep(size_t index, const ShownImage& image, Extent extent)
{
    return impl_->keep(index, image, extent);
}
Result<Picture> Presenter::read(const ShownImage& image)
{
    return impl_->read(image);
}

} // namespace passgraph
