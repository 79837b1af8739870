// The plan as JSON, for tools.
#include <array>
#include <cmath>

#include "passgraph/core/json_value.hpp"
#include "passgraph/core/plan.hpp"

namespace passgraph {
namespace {

using Object = JsonValue;

Object extent_json(Extent extent) { return Object::array({extent.width, extent.height}); }

Object bound_json(double bound) { return std::isfinite(bound) ? Object(bound) : Object(nullptr); }

Object read_json(const Plan::Read& read)
{
    static constexpr std::array<const char*, 3> kWraps = {"clamp", "mirror", "repeat"};
    return {{"image", read.image},
            {"source", read.source == Plan::Read::Source::slot ? "slot" : "import"},
            {"index", read.index},
            {"sampler", read.sampler},
            {"filter", read.filter == Filter::linear ? "linear" : "nearest"},
            {"loaded", read.is_loaded},
            {"wrap", kWraps[static_cast<size_t>(read.wrap)]},
            {"levels", read.has_levels}};
}

Object uniform_json(const Plan::Uniform& uniform)
{
    Object value = Object::array();
    for (int i = 0; i < component_count(uniform.type); ++i)
        value.push_back(uniform.value.v[static_cast<size_t>(i)]);
    return {{"place", uniform.place},
            {"name", uniform.name},
            {"type", name(uniform.type)},
            {"value", value},
            {"range", Object::array({bound_json(uniform.lowest), bound_json(uniform.highest)})}};
}

Object step_json(const Plan::Step& step, bool with_glsl)
{
    Object json = {{"name", step.name},
                   {"kind", step.kind == Plan::Step::Kind::geometry ? "geometry" : "draw"},
                   {"passes", step.passes},
                   {"extent", extent_json(step.extent)},
                   {"reads", Object::array()},
                   {"targets", Object::array()},
                   {"depth_slot", step.depth_slot < 0 ? Object(nullptr) : Object(step.depth_slot)},
                   {"tested_depth_slot", step.tested_depth_slot < 0 ? Object(nullptr) : Object(step.tested_depth_slot)},
                   {"counts", step.counts < 0 ? Object(nullptr) : Object(step.counts)},
                   {"scout_extent", step.scout.empty() ? Object(nullptr) : extent_json(step.scout_extent)},
                   {"skipped_by", step.skipped_by < 0 ? Object(nullptr) : Object(step.skipped_by)},
                   {"variant_without", step.black_images},
                   {"uniforms", Object::array()},
                   {"host", Object::array()}};
    for (const Plan::Read& read : step.reads)
        json["reads"].push_back(read_json(read));
    for (const Plan::Target& target : step.targets)
        json["targets"].push_back({{"slot", target.slot}, {"image", target.image}});
    for (const Plan::Uniform& uniform : step.uniforms)
        json["uniforms"].push_back(uniform_json(uniform));
    for (const ReadRow& row : kReads)
        if (step.host.*row.member)
            json["host"].push_back(row.name);
    if (with_glsl) {
        json["vertex"] = step.vertex;
        json["fragment"] = step.fragment;
        if (!step.background.empty())
            json["background"] = step.background;
        if (!step.when_skipped.empty())
            json["when_skipped"] = step.when_skipped;
        if (!step.scout.empty())
            json["scout"] = step.scout;
        json["sources"] = step.sources;
    }
    return json;
}

} // namespace

std::string to_json(const Plan& plan, bool with_glsl)
{
    static constexpr std::array<const char*, 4> kImportKinds = {"picture", "cube", "sky", "atlas"};
    Object json = {{"passgraph", 1},
                   {"extent", extent_json(plan.extent)},
                   {"bytes", plan.bytes},
                   {"bytes_unshared", plan.bytes_unshared}};
    for (const char* list : {"imports", "slots", "steps", "queries", "inlined", "boundaries", "culled", "decisions", "outputs"})
        json[list] = Object::array();
    for (const Plan::Import& import : plan.imports)
        json["imports"].push_back({{"name", import.name},
                                   {"kind", kImportKinds[static_cast<size_t>(import.kind)]},
                                   {"signal", info(import.signal).name},
                                   {"extent", extent_json(import.extent)}});
    for (const Plan::Slot& slot : plan.slots)
        json["slots"].push_back(
            {{"format", name(slot.format)}, {"extent", extent_json(slot.extent)}, {"images", slot.images}});
    for (const Plan::Step& step : plan.steps)
        json["steps"].push_back(step_json(step, with_glsl));
    for (const Plan::Query& query : plan.queries)
        json["queries"].push_back({{"step", query.step}, {"images", query.images}});
    json["inlined"] = plan.inlined;
    for (const Plan::Boundary& boundary : plan.boundaries)
        json["boundaries"].push_back(
            {{"image", boundary.image}, {"reader", boundary.reader}, {"reason", boundary.reason}});
    for (const Plan::Culled& culled : plan.culled)
        json["culled"].push_back({{"pass", culled.pass}, {"reason", culled.reason}});
    for (const Plan::Decision& decision : plan.decisions)
        json["decisions"].push_back({{"what", decision.what}, {"reason", decision.reason}});
    json["facts"] = Object::object();
    for (const FactRow& row : all_facts())
        if (row.set != nullptr)
            json["facts"][std::string(row.name)] = std::isfinite(row.get(plan.facts)) ? Object(row.get(plan.facts)) : Object(nullptr);
    for (const Plan::Output& output : plan.outputs)
        json["outputs"].push_back({{"name", output.name},
                                   {"image", output.image},
                                   {"source", output.source == Plan::Read::Source::slot ? "slot" : "import"},
                                   {"index", output.index},
                                   {"signal", info(output.signal).name},
                                   {"codec", output.codec.name},
                                   {"extent", extent_json(output.extent)}});
    return json.text(2) + "\n";
}

} // namespace passgraph
