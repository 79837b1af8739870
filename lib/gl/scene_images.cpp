// The atlas and the sky of a scene, before the device has them.
#include "gl/scene_images.hpp"

#include "gl/cube_faces.hpp"
#include "gl/scene_buffers.hpp"

namespace passgraph {
namespace gl {

Result<SceneImages::Impl> make_scene_images(const Scene& scene, const Limits& limits)
{
    if (Errors errors = find_scene_errors(scene, limits); !errors.empty())
        return tl::unexpected(std::move(errors));
    SceneImages::Impl images;
    images.facts = facts_of(scene);
    const std::vector<LampReach> reaching = lamp_reaches(scene);
    for (const bool reaches : {true, false})
        for (size_t i = 0; i < reaching.size(); ++i)
            if (reaching[i].to_surface == reaches)
                images.lights.push_back(static_cast<int>(i));
    if (scene.sky.is_present()) {
        const auto faces = cube_faces(scene.sky.faces, Signal::radiance, "the sky", limits);
        if (!faces)
            return tl::unexpected(faces.error());
        images.sky = cube_levels(*faces);
    }
    Result<Atlas> atlas = make_atlas(scene, limits.texture_size);
    if (!atlas)
        return tl::unexpected(std::move(atlas.error()));
    images.atlas = std::move(*atlas);
    return images;
}

} // namespace gl

SceneImages::SceneImages(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneImages::SceneImages(SceneImages&&) noexcept = default;
SceneImages& SceneImages::operator=(SceneImages&&) noexcept = default;
SceneImages::~SceneImages() = default;
const Facts& SceneImages::facts() const { return impl_->facts; }

} // namespace passgraph
