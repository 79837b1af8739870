// Materials and textures of glTF models.
#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::Folder;

namespace {

/// A textured triangle; the pictures of tests/data/models lie beside it.
test::Loaded with_material(const std::string& material, const std::string& more = "")
{
    const Folder folder;
    for (const char* name : {"grey.png", "grey_alpha.png", "deep.png", "deep_grey.png", "deep_grey_alpha.png", "deep_alpha.png",
                             "palette.png", "one_bit.png"})
        std::filesystem::copy_file(test::data_file(std::string("models/") + name), folder.path(name));
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.add_floats({0, 0, 1, 0, 0, 1}, 2);
    model.add_floats({5, 5, 6, 6, 7, 7}, 2);
    return test::load_model(
        model.write(folder, test::one_mesh("\"material\":0,\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,"
                                           "\"TEXCOORD_1\":2}",
                                           ",\"materials\":[{" + material + "}]" + more)));
}

test::Loaded with_picture(const std::string& file)
{
    return with_material("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}",
                         ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"" + file + "\"}]");
}

} // namespace

TEST_CASE("a material's factors and extensions are taken over", "[scene][gltf]")
{
    const auto loaded = with_material(
        "\"name\":\"paint\",\"doubleSided\":true,\"emissiveFactor\":[1,0.5,0],\"pbrMetallicRoughness\":{"
        "\"baseColorFactor\":[0.1,0.2,0.3,0.4],\"metallicFactor\":0.25,\"roughnessFactor\":0.75},\"extensions\":{"
        "\"KHR_materials_specular\":{\"specularFactor\":0.5},\"KHR_materials_emissive_strength\":{"
        "\"emissiveStrength\":8}}");
    REQUIRE(loaded.mistakes == "");
    const Material& material = loaded.scene.materials[0];
    CHECK(material.name == "paint");
    CHECK(material.base_color == glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    CHECK(material.metallic == 0.25f);
    CHECK(material.roughness == 0.75f);
    CHECK(material.specular == 0.25f);
    CHECK(material.emissive == glm::vec3(8, 4, 0));
    CHECK(material.is_double_sided);
    CHECK(material.base_color_texture == -1);
}

TEST_CASE("an empty material and no material at all are glTF's default", "[scene][gltf]")
{
    const Folder folder;
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    const auto none = test::load_model(model.write(folder, test::one_mesh("\"attributes\":{\"POSITION\":0}")));
    const auto empty = with_material("");
    for (const Material& material : {none.scene.materials.at(0), empty.scene.materials.at(0)}) {
        CHECK(material.base_color == glm::vec4(1));
        CHECK(material.metallic == 1.0f);
        CHECK(material.roughness == 1.0f);
        CHECK(material.specular == 0.5f);
        CHECK(material.emissive == glm::vec3(0));
    }
}

TEST_CASE("grey and grey with alpha become RGBA", "[scene][gltf]")
{
    CHECK(with_picture("grey.png").scene.textures.at(0).rgba ==
          std::vector<std::uint8_t>{0, 0, 0, 255, 128, 128, 128, 255});
    CHECK(with_picture("grey_alpha.png").scene.textures.at(0).rgba == std::vector<std::uint8_t>{100, 100, 100, 50});
}

TEST_CASE("16-bit codes are rounded to the nearest 8-bit code", "[scene][gltf]")
{
    CHECK(with_picture("deep.png").scene.textures.at(0).rgba == std::vector<std::uint8_t>{0, 128, 255, 255, 1, 1, 1, 255});
}

TEST_CASE("every kind of PNG becomes RGBA, 16 bits and transparency included", "[scene][gltf]")
{
    using Codes = std::vector<std::uint8_t>;
    const auto codes = [](const std::string& file) { return with_picture(file).scene.textures.at(0).rgba; };
    // The nearest of 257 * code: 0x8080 is 128 itself, 0x00ff is 0.99, 0x807f just below 128.
    CHECK(codes("deep_grey.png") == Codes{128, 128, 128, 255, 1, 1, 1, 255, 128, 128, 128, 255});
    CHECK(codes("deep_grey_alpha.png") == Codes{255, 255, 255, 51, 1, 1, 1, 255});
    CHECK(codes("deep_alpha.png") == Codes{18, 171, 255, 128}); // 0x1234 is 18.1, 0xabcd 171.1, 0x8000 127.5 and a bit
    CHECK(codes("palette.png") == Codes{255, 0, 0, 128, 0, 255, 0, 255, 1, 2, 3, 255, 255, 0, 0, 128});
    CHECK(codes("one_bit.png") == Codes{255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255});
}

TEST_CASE("a texture used as color and as data becomes two, used twice as color one", "[scene][gltf]")
{
    const auto loaded = with_material(
        "\"emissiveTexture\":{\"index\":0},\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},"
        "\"metallicRoughnessTexture\":{\"index\":0}}",
        ",\"textures\":[{\"source\":0,\"sampler\":0}],\"images\":[{\"uri\":\"grey.png\"}],"
        "\"samplers\":[{\"wrapS\":33071,\"wrapT\":33648}]");
    REQUIRE(loaded.mistakes == "");
    const auto& textures = loaded.scene.textures;
    REQUIRE(textures.size() == 2);
    CHECK(textures[0].is_srgb);
    CHECK_FALSE(textures[1].is_srgb);
    CHECK(textures[0].wrap_u == Wrap::clamp);
    CHECK(textures[0].wrap_v == Wrap::mirror);
    CHECK(loaded.scene.materials[0].emissive_texture == 0);
    CHECK(loaded.scene.materials[0].metallic_roughness_texture == 1);
}

TEST_CASE("the material chooses the texture coordinate set, and may not choose two", "[scene][gltf]")
{
    const std::string images = ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"grey.png\"}]";
    const auto second =
        with_material("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":1}}", images);
    REQUIRE(second.mistakes == "");
    CHECK(second.scene.meshes[0].vertices[0].uv == glm::vec2(5, 5));
    const auto both = with_material("\"emissiveTexture\":{\"index\":0},\"pbrMetallicRoughness\":{\"baseColorTexture\":{"
                                    "\"index\":0,\"texCoord\":1}}",
                                    images);
    CHECK_THAT(both.mistakes, Catch::Contains("gltf_unsupported") && Catch::Contains("different texture coordinates"));
}

TEST_CASE("an image that cannot be decoded matters only when it is used", "[scene][gltf]")
{
    const std::string images = ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"model.bin\"}]";
    CHECK(with_material("", images).mistakes == "");
    CHECK_THAT(with_material("\"emissiveTexture\":{\"index\":0}", images).mistakes, Catch::Contains("images[0]"));
}
