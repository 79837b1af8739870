// What a right pass file declares: short and long forms, names at global scope, includes, what analysis derived.
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

TEST_CASE("short forms stand for the long ones", "[core][pass]")
{
    const PassDeclaration pass = read_pass(R"(/*{
  "pass": "own", // comments are allowed
  "inputs": { "image": "display" },
  "outputs": { "color": "radiance" },
  "params": { "strength": 0.5, "on": true, "center": [0.5, 0.25], "tint": [1, 2, 3], "rect": [1, 2, 3, 4] },
  "choices": { "shape": ["round", "square"] },
  "ladders": { "taps": { "items": [5, 9, "13"], "default": 9 } }
}*/)");
    CHECK(pass.name == "own");
    CHECK(pass.family == "test");
    CHECK(pass.kind == PassKind::image);
    REQUIRE(pass.inputs.size() == 1);
    CHECK(pass.inputs[0].signal == Signal::display);
    CHECK(pass.inputs[0].filter == Filter::nearest);
    CHECK(pass.inputs[0].wrap == AddressMode::clamp);
    CHECK(pass.inputs[0].over == Over::image);
    CHECK(pass.inputs[0].access == Access{AccessClass::gather, Access::kUnknownRadius}); // the safest, until derived
    CHECK(pass.outputs[0].signal == Signal::radiance);
    REQUIRE(pass.params.size() == 5);
    CHECK(pass.params[0].type == ParamType::float_);
    CHECK(pass.params[0].default_value == Value(0.5));
    CHECK(!pass.params[0].is_static);
    CHECK(pass.params[1].type == ParamType::bool_);
    CHECK(pass.params[1].default_value == Value(1.0));
    CHECK(pass.params[2].type == ParamType::vec2);
    CHECK(pass.params[3].type == ParamType::vec3);
    CHECK(pass.params[4].default_value == Value(1, 2, 3, 4));
    REQUIRE(pass.selections.size() == 2);
    CHECK(pass.selections[0].items == std::vector<std::string>{"round", "square"});
    CHECK(pass.selections[1].kind == Selection::Kind::ladder);
    CHECK(pass.selections[1].items == std::vector<std::string>{"5", "9", "13"});
    CHECK(pass.selections[1].default_item == 1);
}

TEST_CASE("long forms say everything about ports and parameters", "[core][pass]")
{
    const PassDeclaration pass = read_pass(R"(/*{
  "pass": "own", "summary": "s", "source": "t", "reads": ["camera", "lights", "frame"],
  "inputs": { "image": { "signal": "color", "filter": "linear", "wrap": "mirror", "levels": true },
              "sky": { "signal": "radiance", "over": "sphere", "optional": true, "default": [1, 2, 3] },
              "glow": { "signal": "radiance", "optional": true, "default": 4 } },
  "outputs": { "color": { "signal": "color", "size": { "of": "image", "scale": [2, 3] } } },
  "params": { "k": { "type": "float", "default": 1, "range": [0.5, 8], "step": 0.5, "unit": "m", "label": "L", "group": "G",
                     "visible_if": "k > 0", "scale": "log", "static": true },
              "tint": { "type": "color", "default": [0.1, 0.2, 0.3] },
              "mode": { "type": "enum", "items": ["a", "b"], "default": "b" } }
}*/)");
    CHECK(pass.reads.camera);
    CHECK(pass.reads.lights);
    CHECK(pass.reads.frame);
    CHECK(!pass.reads.elements);
    CHECK(pass.inputs[0].filter == Filter::linear);
    CHECK(pass.inputs[0].wrap == AddressMode::mirror);
    CHECK(pass.inputs[0].has_levels);
    CHECK(pass.inputs[1].over == Over::sphere);
    CHECK(pass.inputs[1].is_optional);
    CHECK(pass.inputs[1].default_value == Value(1, 2, 3));
    CHECK(pass.inputs[2].default_value.v[2] == 4.0);
    CHECK(pass.outputs[0].size_of == "image");
    CHECK(pass.outputs[0].scale == Ratio{2, 3});
    const Param& k = pass.params[0];
    CHECK(k.lowest == 0.5);
    CHECK(k.highest == 8.0);
    CHECK(k.step == 0.5);
    CHECK(k.unit + k.label + k.group + k.visible_if->text() == "mLGk > 0");
    CHECK(k.is_logarithmic);
    CHECK(k.is_static);
    CHECK(pass.params[1].lowest == 0.0); // colors are reflectances unless a range says otherwise
    CHECK(pass.params[1].highest == 1.0);
    CHECK(pass.params[2].default_value == Value(1));
    CHECK(pass.find_input("sky") == 1);
    CHECK(pass.find_param("mode") == 2);
    CHECK(pass.find_output("none") == -1);
}

TEST_CASE("a geometry pass draws a scene and selects a layout", "[core][pass]")
{
    const PassDeclaration pass = read_pass(R"(/*{ "pass": "own", "kind": "geometry",
  "outputs": { "normal": "normal", "depth": "depth" },
  "layouts": { "small": { "normal": "octahedral_rg8" }, "large": { "normal": "rgba32f", "depth": "depth24" } } }*/)");
    REQUIRE(pass.inputs.size() == 1);
    CHECK(pass.inputs[0].name == "scene");
    CHECK(pass.inputs[0].over == Over::scene);
    REQUIRE(pass.selections.size() == 1);
    CHECK(pass.selections[0].name == "layout");
    CHECK(pass.selections[0].items == std::vector<std::string>{"small", "large"});
    REQUIRE(pass.layouts[1].outputs.size() == 2);
    CHECK(pass.layouts[1].targets[1].format == Format::depth24);
    CHECK(to_text(pass.layouts[0], pass.layouts[0].outputs[0]) == "normal.rg : octahedral_rg8");
}

TEST_CASE("names at global scope are found, those inside bodies are not", "[core][pass]")
{
    const PassDeclaration pass = read_pass(R"(/*{ "pass": "own", "outputs": { "color": "color" } }*/
#define TWICE(x) (2.0 * (x))
  #define NEAR 0.1
#if NEAR > 0.0
const float near_edge = NEAR, far_edge = 2.0;
#else
const float near_edge = 0.0;
#endif
struct Lamp { vec3 place; float power; };
const float weights[3] = float[3](0.1, 0.2, 0.3);
float helper(float x, float y); // declared, then defined
float helper(float x, float y) { float inner = x; const float other = y; return inner * other; }
Lamp lamp_at(int i) { Lamp lamp; return lamp; }
vec3 own(vec2 uv) { for (int i = 0; i < 3; ++i) helper(uv.x, uv.y); return vec3(TWICE(near_edge)); }
)");
    CHECK(pass.body.globals == std::vector<std::string>{"near_edge", "far_edge", "Lamp", "weights", "helper", "lamp_at", "own"});
    CHECK(pass.body.macros == std::vector<std::string>{"TWICE", "NEAR"});
    CHECK(pass.body.first_line == 1);
}

TEST_CASE("an include is read once, and its line stays blank so that lines keep their numbers", "[core][pass]")
{
    int asked = 0;
    const auto pass = read_pass_header("/*{ \"pass\": \"own\",\n\"outputs\": { \"color\": \"color\" } }*/\n#include \"a.glsl\"\n#include \"b.glsl\"\nvec3 own(vec2 uv);\n",
                                       "p.glsl", "test", [&](std::string_view name) -> std::optional<IncludedFile> {
                                           ++asked;
                                           return IncludedFile{std::string(name), name == "a.glsl" ? "#include \"b.glsl\"\nfloat a_one() { return b_one(); }\n"
                                                                                                   : "float b_one() { return 1.0; }\n"};
                                       });
    REQUIRE(pass);
    REQUIRE(pass->body.includes.size() == 2);
    CHECK(pass->body.includes[0]->globals == std::vector<std::string>{"a_one"});
    CHECK(pass->body.includes[0]->includes.front() == pass->body.includes[1]); // one text, however it is reached
    CHECK(pass->body.first_line == 2);
    CHECK(pass->body.text == "\n                 \n                 \nvec3 own(vec2 uv);\n");
    CHECK(asked == 3);
}

TEST_CASE("what analysis derived survives being baked", "[core][pass]")
{
    PassDeclaration pass = read_pass(R"(/*{ "pass": "own", "outputs": { "color": "color" },
  "inputs": { "one": "color", "two": "color", "three": "color", "four": "color" } }*/)" + std::string("\n"));
    const PassDeclaration fresh = pass;
    pass.inputs[0].access = {AccessClass::pointwise, 0};
    pass.inputs[1].access = {AccessClass::gather, 4};
    pass.inputs[2].access = {AccessClass::warp, 0};
    pass.inputs[3].access = {AccessClass::size_only, 0};
    PassDeclaration read = fresh;
    REQUIRE(apply_derived(read, derived_to_json(pass)));
    for (size_t i = 0; i < 4; ++i)
        CHECK(read.inputs[i].access == pass.inputs[i].access);
    PassDeclaration broken = fresh;
    CHECK(!apply_derived(broken, "{"));
    CHECK(!apply_derived(broken, R"({ "one": 5 })"));
    CHECK(to_text(Access{AccessClass::gather, 4}) == "gather(4)");
    CHECK(to_text(Access{}) == "gather(radius unknown)");
    CHECK(to_text(Access{AccessClass::pointwise, 0}) == "pointwise");
}

TEST_CASE("a library replaces a pass of the same name and lists names in order", "[core][pass]")
{
    PassLibrary library;
    library.add(PassMaker("b").output("color").done());
    const PassPtr second = PassMaker("a").output("color").done();
    library.add(PassMaker("a").output("color").done());
    library.add(second);
    CHECK(library.find("a") == second);
    CHECK(library.find("c") == nullptr);
    CHECK(library.names() == std::vector<std::string>{"a", "b"});
}
