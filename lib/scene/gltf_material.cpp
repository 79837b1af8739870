// glTF materials and the textures they use, each taken over once.
#include <algorithm>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr int kNone = -1;
constexpr float kBrightest = 65504.0f; // the largest half: the domain of radiance

float unit(double value)
{
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// A number of a material's extension, which the rules have checked.
double extension_number(const tinygltf::Material& material, const char* extension, const char* key, double fallback)
{
    const auto found = material.extensions.find(extension);
    if (found == material.extensions.end() || !found->second.Has(key))
        return fallback;
    return found->second.Get(key).GetNumberAsDouble();
}

Wrap wrap_of(int mode)
{
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE)
        return Wrap::clamp;
    return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

} // namespace

int Materials::index_of(int material)
{
    if (const auto known = materials_.find(material); known != materials_.end())
        return known->second;
    const int index = static_cast<int>(into_.materials.size());
    materials_[material] = index;
    into_.materials.push_back(material == kNone ? Material{.name = "default"} : read(material));
    return index;
}

int Materials::uv_set_of(int material)
{
    if (material == kNone)
        return 0;
    const tinygltf::Material& from = file_.model.materials[static_cast<size_t>(material)];
    const auto& pbr = from.pbrMetallicRoughness;
    int set = kNone;
    bool is_one = true;
    const auto use = [&](int texture, int wanted) {
        if (texture == kNone)
            return;
        is_one = is_one && (set == kNone || set == wanted);
        set = set == kNone ? wanted : set;
    };
    use(pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord);
    use(pbr.metallicRoughnessTexture.index, pbr.metallicRoughnessTexture.texCoord);
    use(from.emissiveTexture.index, from.emissiveTexture.texCoord);
    if (!is_one) {
        errors_.push_back(unsupported(place_of(file_, "materials", material),
                                      fmt::format("materials[{}]: its textures use different texture coordinates",
                                                  material),
                                      "a vertex has one pair: export with one set"));
    }
    return std::max(set, 0);
}

Material Materials::read(int material)
{
    const tinygltf::Material& from = file_.model.materials[static_cast<size_t>(material)];
    const auto& pbr = from.pbrMetallicRoughness;
    const Location where = place_of(file_, "materials", material);
    Material result;
    result.name = from.name;
    for (int c = 0; c < 4 && pbr.baseColorFactor.size() == 4; ++c)
        result.base_color[c] = unit(pbr.baseColorFactor[static_cast<size_t>(c)]);
    result.metallic = unit(pbr.metallicFactor);
    result.roughness = unit(pbr.roughnessFactor);
    result.specular = 0.5f * unit(extension_number(from, "KHR_materials_specular", "specularFactor", 1.0));
    const double strength = extension_number(from, "KHR_materials_emissive_strength", "emissiveStrength", 1.0);
    for (int c = 0; c < 3 && from.emissiveFactor.size() == 3; ++c) {
        const double emissive = from.emissiveFactor[static_cast<size_t>(c)] * strength;
        result.emissive[c] = static_cast<float>(std::clamp(emissive, 0.0, static_cast<double>(kBrightest)));
    }
    result.base_color_texture = texture_of(pbr.baseColorTexture.index, true, where);
    result.metallic_roughness_texture = texture_of(pbr.metallicRoughnessTexture.index, false, where);
    result.emissive_texture = texture_of(from.emissiveTexture.index, true, where);
    result.is_double_sided = from.doubleSided;
    return result;
}

int Materials::texture_of(int texture, bool is_srgb, const Location& where)
{
    if (texture == kNone)
        return kNone;
    const tinygltf::Texture& from = file_.model.textures[static_cast<size_t>(texture)];
    if (from.source == kNone) {
        errors_.push_back(unsupported(where, fmt::format("textures[{}] has no PNG or JPEG image", texture)));
        return kNone;
    }
    if (const auto broken = file_.broken_images.find(from.source); broken != file_.broken_images.end()) {
        errors_.push_back(malformed(place_of(file_, "images", from.source),
                                    fmt::format("images[{}]: {}", from.source, broken->second)));
        return kNone;
    }
    Wrap wraps[2] = {Wrap::repeat, Wrap::repeat};
    if (from.sampler != kNone) {
        const tinygltf::Sampler& sampler = file_.model.samplers[static_cast<size_t>(from.sampler)];
        wraps[0] = wrap_of(sampler.wrapS);
        wraps[1] = wrap_of(sampler.wrapT);
    }
    const std::array<int, 4> key{from.source, static_cast<int>(wraps[0]), static_cast<int>(wraps[1]), is_srgb ? 1 : 0};
    if (const auto known = textures_.find(key); known != textures_.end())
        return known->second;
    const tinygltf::Image& image = file_.model.images[static_cast<size_t>(from.source)];
    texture_bytes_ += image.image.size();
    if (texture_bytes_ > Limits::kTextureBytes) {
        errors_.push_back(malformed(where, fmt::format("the textures have more than {} bytes together",
                                                       Limits::kTextureBytes)));
        return kNone;
    }
    const int index = static_cast<int>(into_.textures.size());
    into_.textures.push_back({image.name.empty() ? image.uri : image.name, {image.width, image.height}, image.image,
                              wraps[0], wraps[1], is_srgb});
    textures_[key] = index;
    return index;
}

} // namespace passgraph::gltf
