// A ready atlas: elements that show a cell of a picture in place of their model's textures.
#include <passgraph/image/image_file.hpp>

#include "files.hpp"
#include "scene/atlas_scenes.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// A picture whose file has the codes first, first + 1, … in red, from the top left, row by row.
void write_counting(const Folder& folder, const std::string& name, Extent extent, int first)
{
    Picture picture(extent, 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (int c = 0; c < 3; ++c)
                picture.at(x, extent.height - 1 - y, c) =
                    static_cast<float>(c == 0 ? first + y * extent.width + x : 10 * c) / 255.0f;
    REQUIRE(write_picture(folder.path(name), picture));
}

void write_model(const Folder& folder)
{
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.write(folder, test::one_mesh("\"attributes\":{\"POSITION\":0},\"material\":0",
                                       ",\"materials\":[{\"name\":\"own\",\"emissiveFactor\":[0.5,0,0],"
                                       "\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.2,0.3,1],\"roughnessFactor\":0.25,"
                                       "\"metallicFactor\":0.5}}]"));
}

/// The scene file's atlas and elements; three elements of one model unless told otherwise.
Result<Scene> load(const Folder& folder, const std::string& atlas, const std::string& elements)
{
    write_model(folder);
    return load_scene(folder.write("s.json", "{\"passgraph_scene\": 1,\n \"atlas\": {" + atlas + "},\n \"elements\": [" + elements + "]}"));
}

std::string element(const std::string& more)
{
    return "{\"model\": \"model.gltf\"" + more + "}";
}

const Material& material_of(const Scene& scene, size_t element)
{
    return scene.materials[static_cast<size_t>(scene.meshes[static_cast<size_t>(scene.elements[element].mesh)].material)];
}

void check_one(const Result<Scene>& scene, const std::string& code, const std::string& says, int line)
{
    REQUIRE_FALSE(scene);
    INFO(to_text(scene.error()));
    REQUIRE(scene.error().size() == 1);
    const Error& error = scene.error()[0];
    CHECK(error.code == code);
    CHECK_THAT(error.message, Catch::Contains(says));
    CHECK_THAT(error.where.file, Catch::EndsWith("s.json"));
    CHECK(error.where.line == line);
    CHECK(error.where.column > 1);
}

} // namespace

TEST_CASE("elements show the cells they name, counted from the top left", "[scene][atlas]")
{
    const Folder folder;
    write_counting(folder, "color.png", {4, 6}, 0);
    write_counting(folder, "data.png", {2, 2}, 100);
    const auto scene = load(folder, "\"albedo\": \"color.png\", \"material\": \"data.png\", \"cells\": [2, 2]",
                            element(", \"cell\": [0, 0]") + "," + element(", \"name\": \"b\", \"cell\": [1, 1], \"wrap\": \"mirror\"") +
                                "," + element(", \"name\": \"c\""));
    REQUIRE(scene);
    const auto reds = [&](int texture) {
        std::vector<int> codes;
        for (size_t i = 0; i < scene->textures[static_cast<size_t>(texture)].rgba.size(); i += 4)
            codes.push_back(scene->textures[static_cast<size_t>(texture)].rgba[i]);
        return codes;
    };
    const Material& first = material_of(*scene, 0);
    CHECK(reds(first.base_color_texture) == std::vector<int>{0, 1, 4, 5, 8, 9});
    CHECK(reds(first.metallic_roughness_texture) == std::vector<int>{100});
    CHECK(first.specular_texture == first.metallic_roughness_texture);
    CHECK(first.base_color == glm::vec4(1));
    CHECK((first.specular == 1.0f && first.roughness == 1.0f && first.metallic == 1.0f));
    CHECK(first.emissive == glm::vec3(0.5f, 0, 0)); // the atlas has no picture for it
    const Material& second = material_of(*scene, 1);
    CHECK(reds(second.base_color_texture) == std::vector<int>{14, 15, 18, 19, 22, 23});
    const Texture& texture = scene->textures[static_cast<size_t>(second.base_color_texture)];
    CHECK(texture.extent == Extent{2, 3});
    CHECK((texture.wrap_u == Wrap::mirror && texture.wrap_v == Wrap::mirror));
    CHECK(texture.is_srgb);
    CHECK_FALSE(scene->textures[static_cast<size_t>(second.specular_texture)].is_srgb);
    const Material& own = material_of(*scene, 2);
    CHECK(own.base_color_texture == -1);
    CHECK(own.roughness == 0.25f);
    SECTION("and the atlas that is made holds specular, roughness, metallic in that order")
    {
        const Atlas atlas = atlas_of(*scene);
        const AtlasCell& cell = atlas.cells[static_cast<size_t>(scene->meshes[0].material)];
        const AtlasRect rect = cell.levels[0];
        CHECK((rect.width == 2 && rect.height == 3));
        CHECK(texel(atlas, atlas.material, rect.x, rect.y, 0) == 100);
        CHECK(texel(atlas, atlas.material, rect.x, rect.y, 1) == 10);
        CHECK(texel(atlas, atlas.material, rect.x, rect.y, 2) == 20);
        CHECK(texel(atlas, atlas.albedo, rect.x + 1, rect.y + 2, 0) == 9);
    }
}

TEST_CASE("elements of one model and cell share their meshes, other cells have their own", "[scene][atlas]")
{
    const Folder folder;
    write_counting(folder, "color.png", {2, 1}, 0);
    const auto scene = load(folder, "\"albedo\": \"color.png\", \"cells\": [2, 1]",
                            element(", \"cell\": [0, 0]") + "," + element(", \"name\": \"b\", \"cell\": [0, 0]") + "," +
                                element(", \"name\": \"c\", \"cell\": [1, 0]"));
    REQUIRE(scene);
    CHECK(scene->elements[0].mesh == scene->elements[1].mesh);
    CHECK(scene->elements[0].mesh != scene->elements[2].mesh);
}

TEST_CASE("the emissive picture glows as strongly as the scene says", "[scene][atlas]")
{
    const Folder folder;
    write_counting(folder, "color.png", {2, 2}, 0);
    const auto scene = load(folder, "\"albedo\": \"color.png\", \"emissive\": \"color.png\", \"emissive_strength\": 40, \"cells\": [1, 1]",
                            element(", \"cell\": [0, 0]"));
    REQUIRE(scene);
    CHECK(material_of(*scene, 0).emissive == glm::vec3(40));
    CHECK(scene->textures[static_cast<size_t>(material_of(*scene, 0).emissive_texture)].is_srgb);
    CHECK(material_of(*scene, 0).roughness == 0.25f);
}

TEST_CASE("grey and grey with alpha are cells too", "[scene][atlas]")
{
    const Folder folder;
    for (const char* name : {"grey.png", "grey_alpha.png", "deep.png"})
        std::filesystem::copy_file(data_file(std::string("models/") + name), folder.path(name));
    const auto codes = [&](const std::string& name) {
        const auto scene = load(folder, "\"albedo\": \"" + name + "\", \"cells\": [1, 1]", element(", \"cell\": [0, 0]"));
        REQUIRE(scene);
        return scene->textures.at(0).rgba;
    };
    CHECK(codes("grey.png") == std::vector<std::uint8_t>{0, 0, 0, 255, 128, 128, 128, 255});
    CHECK(codes("grey_alpha.png") == std::vector<std::uint8_t>{100, 100, 100, 50});
    CHECK(codes("deep.png") == std::vector<std::uint8_t>{0, 128, 255, 255, 1, 1, 1, 255});
}

TEST_CASE("each mistake of an atlas and of a cell is told at its place", "[scene][atlas][errors]")
{
    const Folder folder;
    write_counting(folder, "color.png", {4, 6}, 0);
    folder.write("text.png", "no picture");
    REQUIRE(write_picture(folder.path("light.exr"), Picture({2, 2}, 3)));
    const std::string color = "\"albedo\": \"color.png\", ";
    const std::string out = "value_out_of_range";
    const auto atlas = [&](const std::string& fields) { return load(folder, fields, element(", \"cell\": [0, 0]")); };
    const auto cell = [&](const std::string& fields) { return load(folder, color + "\"cells\": [2, 2]", element(fields)); };
    check_one(atlas("\"cells\": [2, 2]"), "field_missing", "lacks \"albedo\"", 2);
    check_one(atlas("\"albedo\": \"color.png\""), "field_missing", "lacks \"cells\"", 2);
    check_one(atlas(color + "\"cells\": [2]"), "wrong_type", "\"cells\" wants 2", 2);
    check_one(atlas(color + "\"cells\": 2"), "wrong_type", "\"cells\"", 2);
    check_one(atlas(color + "\"cells\": [2, 0]"), out, "not 0", 2);
    check_one(atlas(color + "\"cells\": [1.5, 2]"), out, "not 1.5", 2);
    check_one(atlas(color + "\"cells\": [3, 2]"), out, "4 x 6 texels, which 3 columns and 2 rows do not divide", 2);
    check_one(atlas(color + "\"cells\": [2, 12]"), out, "12 rows do not divide", 2);
    check_one(atlas("\"albedo\": \"none.png\", \"cells\": [1, 1]"), "file_missing", "none.png", 2);
    check_one(atlas("\"albedo\": \"text.png\", \"cells\": [1, 1]"), "picture_malformed", "text.png", 2);
    check_one(atlas("\"albedo\": \"\", \"cells\": [1, 1]"), out, "names no file", 2);
    check_one(atlas(color + "\"emissive\": \"light.exr\", \"cells\": [1, 1]"), "picture_format", "light.exr", 2);
    check_one(atlas(color + "\"material\": 3, \"cells\": [1, 1]"), "wrong_type", "\"material\"", 2);
    check_one(atlas(color + "\"emissive_strength\": -1, \"cells\": [1, 1]"), out, "-1", 2);
    check_one(atlas(color + "\"cell\": 3, \"cells\": [1, 1]"), "unknown_field", "\"cell\"", 2);
    check_one(cell(", \"cell\": [2, 0]"), out, "the cell [2, 0] of an atlas of 2 x 2", 3);
    check_one(cell(", \"cell\": [0, 2]"), out, "the cell [0, 2]", 3);
    check_one(cell(", \"cell\": [-1, 0]"), out, "not -1", 3);
    check_one(cell(", \"cell\": [0, 0.5]"), out, "not 0.5", 3);
    check_one(cell(", \"cell\": [0]"), "wrong_type", "\"cell\" wants 2", 3);
    check_one(cell(", \"cell\": \"left\""), "wrong_type", "\"cell\"", 3);
    check_one(cell(", \"cell\": [0, 0], \"wrap\": \"mirrored\""), out, "mirrored", 3);
    check_one(cell(", \"wrap\": \"clamp\""), out, "\"wrap\" is for one with a \"cell\"", 3);
}

TEST_CASE("a cell of a scene without an atlas is told, and what an atlas looks like", "[scene][atlas][errors]")
{
    const Folder folder;
    write_model(folder);
    const auto scene = load_scene(folder.write("s.json", "{\"passgraph_scene\": 1, \"elements\": [" + element(", \"cell\": [0, 0]") + "]}"));
    check_one(scene, "field_missing", "the scene has no \"atlas\"", 1);
    CHECK_THAT(scene.error()[0].hint, Catch::Contains("\"cells\": [columns, rows]"));
}
