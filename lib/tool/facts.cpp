// `passgraph facts`: what a scene calls for.
#include <cmath>

#include <fmt/format.h>

#include <passgraph/core/json_value.hpp>
#include <passgraph/scene/facts.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "tool/commands.hpp"
#include "tool/options.hpp"

namespace passgraph::tool {
namespace {

struct FactsOptions {
    std::string scene;
    std::string size;
    bool is_json = false;
};

constexpr std::string_view kKinds[] = {"directional", "point", "spot"};

std::string_view reach_text(const LampReach& reach)
{
    return reach.to_view      ? "lights what may be seen"
           : reach.to_surface ? "lights surfaces, outside of the camera's view"
           : reach.is_on      ? "reaches no surface"
                              : "is off";
}

void print_json(const Scene& scene, const Facts& facts, const std::vector<LampReach>& reaches)
{
    JsonValue json = {{"passgraph", 1}, {"scene", scene.name}};
    for (const FactRow& row : all_facts())
        json["facts"][std::string(row.name)] = row.get(facts);
    json["lamps"] = JsonValue::array();
    for (size_t i = 0; i < reaches.size(); ++i)
        json["lamps"].push_back({{"name", scene.lights[i].name},
                                 {"kind", kKinds[static_cast<size_t>(scene.lights[i].kind)]},
                                 {"is_on", reaches[i].is_on},
                                 {"reaches_surface", reaches[i].to_surface},
                                 {"reaches_view", reaches[i].to_view}});
    fmt::print("{}\n", json.text(2));
}

Result<void> print_facts(const FactsOptions& options)
{
    const Result<Scene> scene = load_scene(options.scene);
    if (!scene)
        return tl::unexpected(scene.error());
    const Facts facts = facts_of(*scene);
    const Extent view = extent_of(options.size).value_or(Extent{1280, 720});
    const std::vector<LampReach> reaches = lamp_reaches(*scene, view);
    if (options.is_json) {
        print_json(*scene, facts, reaches);
        return {};
    }
    fmt::print("{}: at most so much of each\n", scene->name);
    for (const FactRow& row : all_facts())
        fmt::print("  {:<20}{:<12.6g}{}\n", row.name, row.get(facts), row.meaning);
    if (!reaches.empty())
        fmt::print("lamps\n");
    for (size_t i = 0; i < reaches.size(); ++i)
        fmt::print("  {:<20}{:<12}{}\n", scene->lights[i].name, kKinds[static_cast<size_t>(scene->lights[i].kind)], reach_text(reaches[i]));
    return {};
}

} // namespace

void add_facts(CommandLine& line)
{
    const auto options = std::make_shared<FactsOptions>();
    Command command = line.add_command("facts", "Says what a scene calls for: what the compiler may rely on, and what each lamp reaches");
    command.add_option("SCENE", options->scene, "The scene file").required();
    add_extent(command, "--size", options->size, "The view's extent, of which the shape matters");
    command.add_flag("--json", options->is_json, "As a JSON object");
    command.action([options] { return print_facts(*options); });
}

} // namespace passgraph::tool
