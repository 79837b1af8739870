// Scene files that are wrong: every mistake, at its place, in one go.
#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::Folder;

namespace {

Errors mistakes(const std::string& text)
{
    const Folder folder;
    const auto scene = load_scene(folder.write("s.json", text));
    return scene ? Errors{} : scene.error();
}

Errors camera_mistakes(const std::string& fields)
{
    return mistakes("{\"passgraph_scene\": 1, \"camera\": {" + fields + "}}");
}

Errors light_mistakes(const std::string& fields)
{
    return mistakes("{\"passgraph_scene\": 1, \"lights\": [{" + fields + "}]}");
}

Errors element_mistakes(const std::string& fields)
{
    std::string model = test::data_file("models/box01.glb");
    return mistakes("{\"passgraph_scene\": 1, \"elements\": [{\"model\": \"" + model + "\"," + fields + "}]}");
}

void check_one(const Errors& errors, const std::string& code, const std::string& says)
{
    INFO(to_text(errors));
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].code == code);
    CHECK_THAT(errors[0].message, Catch::Contains(says));
    CHECK(errors[0].where.line > 0);
}

const std::string kView = "\"position\": [0,0,3], \"direction\": [0,0,-1]";

} // namespace

TEST_CASE("each mistake of a camera is named", "[scene][errors]")
{
    const std::string out = "value_out_of_range";
    check_one(camera_mistakes("\"direction\": [0,0,-1]"), "field_missing", "lacks \"position\"");
    check_one(camera_mistakes("\"position\": [0,0,3]"), "field_missing", "lacks \"direction\"");
    check_one(camera_mistakes("\"position\": [0,0,3], \"direction\": [0,0,0]"), out, "has length 0");
    check_one(camera_mistakes("\"position\": [0,0,3], \"target\": [0,0,3]"), out, "looks nowhere");
    check_one(camera_mistakes(kView + ", \"target\": [0,0,0]"), out, "both");
    check_one(camera_mistakes(kView + ", \"up\": [0,0,0]"), out, "has length 0");
    check_one(camera_mistakes(kView + ", \"up\": [0,0,5]"), out, "parallel");
    check_one(camera_mistakes("\"position\": [0,0,3], \"direction\": [0,-2,0], \"up\": [0,1,0]"), out, "parallel");
    check_one(camera_mistakes(kView + ", \"near\": 0"), out, "\"near\" is 0");
    check_one(camera_mistakes(kView + ", \"near\": -1"), out, "\"near\" is -1");
    check_one(camera_mistakes(kView + ", \"near\": 5, \"far\": 5"), out, "is not before its \"far\" plane");
    check_one(camera_mistakes(kView + ", \"near\": 9e-16"), out, "at least 1e-15");
    check_one(camera_mistakes(kView + ", \"near\": 1e-14, \"far\": 1e17"), out, "1e+30 times");
    check_one(camera_mistakes(kView + ", \"far\": 0.05"), out, "is not before its \"far\" plane");
    check_one(camera_mistakes(kView + ", \"far\": 1e39"), out, "\"far\"");
    check_one(camera_mistakes(kView + ", \"vertical_fov_degrees\": 0"), out, "vertical_fov_degrees");
    check_one(camera_mistakes(kView + ", \"vertical_fov_degrees\": 180"), out, "vertical_fov_degrees");
    check_one(camera_mistakes(kView + ", \"fov\": 45"), "unknown_field", "\"fov\"");
    check_one(camera_mistakes("\"position\": [0,0], \"direction\": [0,0,-1]"), "wrong_type", "3 finite numbers");
    check_one(camera_mistakes("\"position\": [0,0,1e39], \"direction\": [0,0,-1]"), "wrong_type", "3 finite numbers");
}

TEST_CASE("each mistake of a light is named", "[scene][errors]")
{
    const std::string out = "value_out_of_range";
    const std::string sun = "\"kind\": \"directional\", \"direction\": [0,-1,0]";
    const std::string lamp = "\"kind\": \"point\", \"color\": [1,1,1], \"position\": [0,0,0]";
    check_one(light_mistakes(sun), "field_missing", "lacks \"color\"");
    check_one(light_mistakes(sun + ", \"color\": [1,-0.5,1]"), out, "-0.5");
    check_one(light_mistakes(sun + ", \"color\": [65505,1,1]"), out, "65504");
    check_one(light_mistakes(sun + ", \"color\": [1,1,1], \"radius\": 3"), "unknown_field", "radius");
    check_one(light_mistakes("\"color\": [1,1,1]"), "field_missing", "lacks \"kind\"");
    check_one(light_mistakes("\"color\": [1,1,1], \"kind\": \"spto\""), out, "spto");
    check_one(light_mistakes("\"kind\": \"directional\", \"color\": [1,1,1]"), "field_missing", "direction");
    check_one(light_mistakes("\"kind\": \"directional\", \"color\": [1,1,1], \"direction\": [0,0,0]"), out, "length 0");
    check_one(light_mistakes(lamp), "field_missing", "radius");
    check_one(light_mistakes(lamp + ", \"radius\": 0"), out, "\"radius\" is 0");
    check_one(light_mistakes("\"kind\": \"point\", \"color\": [1,1,1], \"radius\": 1"), "field_missing", "position");
}

TEST_CASE("each mistake of a spot light is named", "[scene][errors]")
{
    const std::string out = "value_out_of_range";
    const std::string spot = "\"kind\": \"spot\", \"color\": [1,1,1], \"position\": [0,0,0], \"radius\": 9";
    const std::string down = spot + ", \"direction\": [0,-1,0]";
    check_one(light_mistakes(spot + ", \"outer_angle_degrees\": 30"), "field_missing", "direction");
    check_one(light_mistakes(down), "field_missing", "outer_angle_degrees");
    check_one(light_mistakes(spot + ", \"direction\": [0,0,0], \"outer_angle_degrees\": 30"), out, "length 0");
    check_one(light_mistakes(down + ", \"outer_angle_degrees\": 0"), out, "lets no light out");
    check_one(light_mistakes(down + ", \"outer_angle_degrees\": 181"), out, "181");
    check_one(light_mistakes(down + ", \"outer_angle_degrees\": 30, \"inner_angle_degrees\": -1"), out, "-1");
    check_one(light_mistakes(down + ", \"outer_angle_degrees\": 30, \"inner_angle_degrees\": 30.5"), out, "30.5");
    check_one(light_mistakes(down + ", \"outer_angle_degrees\": 30, \"angle\": 3"), "unknown_field", "angle");
}

TEST_CASE("each mistake of an element, a sky and the whole is named", "[scene][errors]")
{
    const std::string out = "value_out_of_range";
    check_one(element_mistakes("\"scale\": 0"), out, "\"scale\" is 0");
    check_one(element_mistakes("\"scale\": [1,0,1]"), out, "\"scale\" is 0");
    check_one(element_mistakes("\"scale\": \"big\""), "wrong_type", "scale");
    check_one(element_mistakes("\"scale\": 1e30"), out, "reaches further than 1e+18 metres");
    check_one(element_mistakes("\"position\": [0,2e18,0]"), out, "reaches further than 1e+18 metres");
    check_one(element_mistakes("\"rotation\": [0,0,0]"), "unknown_field", "rotation");
    check_one(element_mistakes("\"position\": [9e17,0,0], \"scale\": 1e17, \"name\": 3"), "wrong_type", "name");
    check_one(mistakes("{\"passgraph_scene\": 1, \"elements\": [{}]}"), "field_missing", "model");
    check_one(mistakes("{\"passgraph_scene\": 1, \"elements\": [{\"model\": \"\"}]}"), out, "names no file");
    check_one(mistakes("{\"passgraph_scene\": 1, \"sky\": {}}"), "field_missing", "faces");
    check_one(mistakes("{\"passgraph_scene\": 1, \"sky\": {\"faces\": \"nowhere\"}}"), "file_missing", "nowhere");
    check_one(mistakes("{\"passgraph_scene\": 1, \"elements\": 3}"), "wrong_type", "\"elements\"");
    check_one(mistakes("{\"passgraph_scene\": 2}"), out, "this program reads 1");
    check_one(mistakes("{}"), "field_missing", "passgraph_scene");
    check_one(mistakes("[]"), "wrong_type", "expected an object");
    check_one(mistakes(""), "json_syntax", "");
}

TEST_CASE("a missing model is reported where it is named, and only once", "[scene][errors]")
{
    const Errors errors = mistakes("{\"passgraph_scene\": 1, \"elements\": [\n  {\"model\": \"no.glb\"},\n"
                                   "  {\"model\": \"no.glb\"}]}");
    check_one(errors, "file_missing", "no.glb");
    CHECK(errors[0].where.line == 2);
    CHECK(errors[0].where.column == 13);
}

TEST_CASE("a sky folder without pictures and a negative intensity are both told", "[scene][errors]")
{
    const Errors errors = mistakes("{\"passgraph_scene\": 1, \"sky\": {\"faces\": \".\", \"intensity\": -1}}");
    CHECK_THAT(to_text(errors), Catch::Contains("\"intensity\" is -1") && Catch::Contains("file_missing"));
}

TEST_CASE("a name used twice is reported at its second place", "[scene][errors]")
{
    const std::string model = "\"model\": \"" + test::data_file("models/box01.glb") + "\"";
    const Errors errors = mistakes("{\"passgraph_scene\": 1, \"elements\": [{\"name\": \"a\", " + model +
                                   "},\n{\"name\": \"a\", " + model + "}]}");
    check_one(errors, "duplicate_name", "`a`");
    CHECK(errors[0].where.line == 2);
}

TEST_CASE("the mistakes of a scene and of its models come in one go", "[scene][errors]")
{
    const Errors errors =
        mistakes("{\"passgraph_scene\": 1, \"nane\": \"x\",\n \"camera\": {\"position\": [0,0,0], \"direction\": [0,0,0], "
                 "\"near\": -1},\n \"elements\": [{\"model\": \"" + test::data_file("malformed/node_cycle.gltf") +
                 "\"}],\n \"lights\": [{\"kind\": \"point\"}]}");
    const std::string text = to_text(errors);
    INFO(text);
    CHECK(errors.size() == 7);
    for (const char* part : {"did you mean `name`?", "length 0", "\"near\" is -1", "cycle", "lacks \"color\"",
                             "lacks \"position\"", "lacks \"radius\""})
        CHECK_THAT(text, Catch::Contains(part));
}

TEST_CASE("a scene file that is missing or a folder says so", "[scene][errors]")
{
    const Folder folder;
    CHECK(load_scene(folder.path("none.json")).error()[0].code == "file_missing");
    CHECK(load_scene(folder.path(".")).error()[0].code == "file_unreadable");
}

TEST_CASE("an element placed at no finite place is reported at the element", "[scene][errors]")
{
    const Folder folder;
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    const std::string path = model.write(folder, "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                                                 "\"nodes\":[{\"mesh\":0,\"scale\":[1e30,1,1]}]");
    const auto scene = load_scene(
        folder.write("s.json", "{\"passgraph_scene\": 1, \"elements\": [\n{\"model\": \"model.gltf\", \"scale\": 1e30}]}"));
    REQUIRE_FALSE(scene);
    check_one(scene.error(), "value_out_of_range", "no finite place");
    CHECK(scene.error()[0].where.line == 2);
}

TEST_CASE("a scene too small to be framed asks for a camera, one too large is none", "[scene][errors]")
{
    const Folder folder;
    test::ModelBuilder model;
    const float size = GENERATE(3e38f, 1.1e18f, 1e-45f);
    const bool is_large = size > 1.0f;
    model.add_floats({0, 0, 0, size, 0, 0, 0, size, 0}, 3);
    const std::string path = model.write(folder, test::one_mesh("\"attributes\":{\"POSITION\":0}"));
    const std::string elements = "\"elements\": [{\"model\": \"model.gltf\"}]}";
    const auto scene = load_scene(folder.write("s.json", "{\"passgraph_scene\": 1, " + elements));
    REQUIRE_FALSE(scene);
    check_one(scene.error(), "value_out_of_range", is_large ? "reaches further" : "to be framed");
    const auto seen = load_scene(folder.write("s.json", "{\"passgraph_scene\": 1, \"camera\": {" + kView + "}, " + elements));
    CHECK(seen.has_value() != is_large);
}

TEST_CASE("the least field of view still gives a camera that can be used", "[scene][errors]")
{
    const Folder folder;
    const auto scene = load_scene(folder.write(
        "s.json", "{\"passgraph_scene\": 1, \"camera\": {" + kView + ", \"vertical_fov_degrees\": 1e-44}}"));
    REQUIRE(scene);
    CHECK(scene->camera.vertical_fov > 0.0f);
}

TEST_CASE("every fault of a sky is told at the scene's \"faces\"", "[scene][errors]")
{
    const Folder folder;
    folder.write("sky/px.png", "no picture");
    folder.write("sky/nx.png", "");
    const auto scene = load_scene(folder.write("s.json", "{\"passgraph_scene\": 1,\n \"sky\": {\"faces\": \"sky\"}}"));
    REQUIRE_FALSE(scene);
    CHECK(scene.error().size() == 6); // two that cannot be read, four that are missing
    for (const Error& error : scene.error()) {
        CHECK(error.where.file == folder.path("s.json"));
        CHECK(error.where.line == 2);
        CHECK(error.where.column == 19);
    }
}

TEST_CASE("a place in the world keeps the double that the file says", "[scene]")
{
    const Folder folder;
    const auto scene = load_scene(folder.write(
        "s.json", "{\"passgraph_scene\": 1, \"camera\": {\"position\": [1000000.1,0,0], \"target\": [1000000.2,0,0]},"
                  "\"lights\": [{\"kind\": \"point\", \"color\": [1,1,1], \"position\": [0,1000000.3,0], \"radius\": 1}],"
                  "\"elements\": [{\"model\": \"" + test::data_file("models/box01.glb") + "\", \"position\": [0,0,1000000.4]}]}"));
    REQUIRE(scene);
    CHECK(scene->camera.position.x == 1000000.1);
    CHECK(scene->camera.direction == glm::vec3(1, 0, 0));
    CHECK(scene->lights[0].position.y == 1000000.3);
    CHECK(scene->elements[0].world_from_model[3][2] == 1000000.4);
}
