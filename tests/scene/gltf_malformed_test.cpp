// Broken models: each is refused with a message that names what points where, and the scene stays as it was.
#include <algorithm>

#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::data_file;

namespace {

struct Broken {
    const char* file;
    const char* code;
    const char* says;
};

constexpr Broken kBroken[] = {
    {"accessor_component_unknown.gltf", "gltf_malformed", "componentType 5130 does not exist"},
    {"accessor_count_absurd.gltf", "gltf_malformed", "accessors[0] has 1000000000000 elements"},
    {"accessor_of_missing_view.gltf", "gltf_malformed", "names bufferViews[9], but there are 2"},
    {"accessor_offset_past_view.gltf", "gltf_malformed", "accessors[0] ends at byte 40 of bufferViews[0]"},
    {"accessor_past_view.gltf", "gltf_malformed", "accessors[0] ends at byte 48 of bufferViews[0], which has 36"},
    {"accessor_type_unknown.gltf", "gltf_malformed", "\"VEC5\" does not exist"},
    {"asset_missing.gltf", "gltf_malformed", "\"asset\" is missing"},
    {"binary_first.glb", "gltf_malformed", "the first chunk of a .glb file"},
    {"binary_too_short.glb", "gltf_malformed", "buffers[0] has 44 bytes, but the .glb file holds 40"},
    {"buffer_empty.gltf", "gltf_malformed", "buffers[0] has no bytes"},
    {"buffer_file_missing.gltf", "file_missing", "nowhere.bin"},
    {"buffer_too_short.gltf", "gltf_malformed", "cannot be read"},
    {"buffer_uri_absolute.gltf", "gltf_malformed", "is no relative path"},
    {"buffer_uri_http.gltf", "gltf_malformed", "is no relative path"},
    {"buffer_uri_missing.gltf", "gltf_malformed", "buffers[0] lacks a uri"},
    {"buffers_too_large.gltf", "gltf_malformed", "at most 2147483648 are read"},
    {"chunk_past_end.glb", "gltf_malformed", "chunk 1 of the .glb file goes past its end"},
    {"data_uri_empty.gltf", "gltf_malformed", "its data: uri holds nothing"},
    {"data_uri_kind.gltf", "gltf_unsupported", "its data: uri is of a kind"},
    {"draco_required.gltf", "gltf_unsupported", "KHR_draco_mesh_compression"},
    {"empty.gltf", "gltf_malformed", "the file is empty"},
    {"factor_not_finite.gltf", "gltf_malformed", "metallicFactor\" is 1e+300"},
    {"image_missing.gltf", "gltf_malformed", "names images[0], but there are 0"},
    {"image_of_missing_view.gltf", "gltf_malformed", "names bufferViews[6]"},
    {"image_too_wide.gltf", "gltf_malformed", "20000 x 1 texels"},
    {"image_two_sources.gltf", "gltf_malformed", "images[0] has either a uri or a bufferView"},
    {"image_undecodable.gltf", "gltf_malformed", "images[0]: it is no picture"},
    {"index_past_vertices.gltf", "gltf_malformed", "index 2 names vertex 3, but there are 3"},
    {"indices_are_floats.gltf", "gltf_malformed", "its indices are no unsigned integers"},
    {"key_twice.gltf", "gltf_malformed", "the key `scene` stands twice"},
    {"material_missing.gltf", "gltf_malformed", "names materials[0], but there are 0"},
    {"mesh_missing.gltf", "gltf_malformed", "names meshes[1], but there are 1"},
    {"no_chunks.glb", "gltf_malformed", "the .glb file has no JSON"},
    {"node_cycle.gltf", "gltf_malformed", "the nodes form a cycle"},
    {"node_matrix_short.gltf", "gltf_malformed", "should have 16 numbers, but has 3"},
    {"node_missing.gltf", "gltf_malformed", "names nodes[5]"},
    {"node_own_child.gltf", "gltf_malformed", "the nodes form a cycle"},
    {"node_rotation_zero.gltf", "gltf_malformed", "zero quaternion"},
    {"node_two_parents.gltf", "gltf_malformed", "nodes[2] has two parents: nodes[0] and nodes[1]"},
    {"nodes_no_list.gltf", "gltf_malformed", "\"nodes\" should be an array"},
    {"normals_too_few.gltf", "gltf_malformed", "NORMAL has 2 elements, POSITION has 3"},
    {"not_gltf.gltf", "gltf_malformed", "this is no glTF"},
    {"odd_chunk.glb", "gltf_malformed", "no multiple of 4 bytes"},
    {"position_is_vec2.gltf", "gltf_malformed", "POSITION has the wrong type"},
    {"position_missing_accessor.gltf", "gltf_malformed", "names accessors[7], but there are 2"},
    {"position_not_finite.gltf", "gltf_malformed", "accessors[0]: element 0 is not finite"},
    {"sampler_missing.gltf", "gltf_malformed", "names samplers[0]"},
    {"scene_missing.gltf", "gltf_malformed", "names scenes[4]"},
    {"skin_missing.gltf", "gltf_malformed", "names skins[0]"},
    {"sparse_count_absurd.gltf", "gltf_malformed", "accessors[0].sparse replaces 4 elements of 3"},
    {"sparse_indices_signed.gltf", "gltf_malformed", "componentType 5122 is no unsigned integer"},
    {"sparse_past_view.gltf", "gltf_malformed", "accessors[0].sparse.indices ends at byte 8"},
    {"sparse_values_past_view.gltf", "gltf_malformed", "accessors[0].sparse.values ends at byte 40"},
    {"stride_below_element.gltf", "gltf_malformed", "overlap at a stride of 8"},
    {"texture_missing.gltf", "gltf_malformed", "names textures[0]"},
    {"texture_without_source.gltf", "gltf_unsupported", "textures[0] has no PNG or JPEG image"},
    {"truncated.glb", "gltf_malformed", "truncated"},
    {"truncated.gltf", "gltf_malformed", "the JSON of this glTF file"},
    {"version_one.glb", "gltf_malformed", "this is glTF 1"},
    {"version_one.gltf", "gltf_malformed", "this is glTF 1.0"},
    {"vertices_absurd.gltf", "gltf_malformed", "16777217 vertices"},
    {"view_empty.gltf", "gltf_malformed", "bufferViews[1] has no bytes"},
    {"view_length_huge.gltf", "gltf_malformed", "should be an integer from 0 to 2^40"},
    {"view_length_wraps.gltf", "gltf_malformed", "should be an integer from 0 to 2^40"},
    {"view_of_missing_buffer.gltf", "gltf_malformed", "names buffers[3], but there are 1"},
    {"view_past_buffer.gltf", "gltf_malformed", "bufferViews[0] ends at byte 45, but buffers[0] has 44"},
    {"view_stride_odd.gltf", "gltf_malformed", "a stride of 13 bytes"},
};

} // namespace

TEST_CASE("every broken model is refused with a message that names the fault", "[scene][gltf]")
{
    for (const Broken& broken : kBroken) {
        INFO(broken.file);
        Scene scene;
        const auto result = append_gltf(scene, data_file(std::string("malformed/") + broken.file), glm::mat4(1.0f), "x");
        REQUIRE_FALSE(result);
        CHECK(result.error()[0].code == broken.code);
        CHECK_THAT(to_text(result.error()), Catch::Contains(broken.says));
        CHECK(scene.meshes.empty());
        CHECK(scene.elements.empty());
        CHECK(scene.materials.empty());
    }
}

TEST_CASE("the table of broken models names every file of their folder", "[scene][gltf]")
{
    for (const auto& entry : std::filesystem::directory_iterator(data_file("malformed"))) {
        INFO(entry.path());
        const auto names_it = [&](const Broken& broken) { return entry.path().filename() == broken.file; };
        CHECK(std::any_of(std::begin(kBroken), std::end(kBroken), names_it));
    }
}

TEST_CASE("a fault of a .gltf has a line, a fault inside a .glb has none", "[scene][gltf]")
{
    Scene scene;
    const auto text = append_gltf(scene, data_file("malformed/mesh_missing.gltf"), glm::mat4(1.0f), "x");
    CHECK(text.error()[0].where.line == 15);
    CHECK(text.error()[0].where.column == 12);
    const auto binary = append_gltf(scene, data_file("malformed/truncated.glb"), glm::mat4(1.0f), "x");
    CHECK(binary.error()[0].where.line == 0);
}

TEST_CASE("a missing model and a folder are told apart from a broken model", "[scene][gltf]")
{
    Scene scene;
    CHECK(append_gltf(scene, data_file("nowhere.glb"), glm::mat4(1.0f), "x").error()[0].code == "file_missing");
    CHECK(append_gltf(scene, data_file("models"), glm::mat4(1.0f), "x").error()[0].code == "file_unreadable");
}

TEST_CASE("every truncation of a .glb is refused", "[scene][gltf]")
{
    std::ifstream stream(data_file("models/box01.glb"), std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    const test::Folder folder;
    for (size_t length = 0; length < whole.size(); length += 97) {
        INFO(length);
        CHECK_FALSE(test::load_model(folder.write("cut.glb", whole.substr(0, length))).mistakes.empty());
    }
}

TEST_CASE("several faults are told at once", "[scene][gltf]")
{
    const test::Folder folder;
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    const auto loaded = test::load_model(
        model.write(folder, "\"nodes\":[{\"mesh\":3,\"skin\":1}],\"scene\":2"));
    CHECK_THAT(loaded.mistakes, Catch::Contains("nodes[0].mesh") && Catch::Contains("nodes[0].skin") &&
                                    Catch::Contains("\"scene\""));
}
