// What a scene file says, checked: its elements, its sky, and the readers that all parts share.
#include "scene_fields.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace passgraph::scene_file {
namespace {

constexpr double kVersion = 1;
constexpr double kLargest = std::numeric_limits<float>::max();

void check_version(JsonFields& fields, Errors& errors)
{
    const Json* version = fields.require("passgraph_scene", Json::Kind::number);
    if (version && version->number != kVersion)
        out_of_range(*version, fmt::format("\"passgraph_scene\" is {}; this program reads 1", version->number), errors);
}

/// A number for all axes, or one per axis. A scale of 0 has no inverse, and so no normals.
glm::vec3 read_scale(JsonFields& fields, Errors& errors)
{
    glm::vec3 scale(1.0f);
    const Json* value = fields.find("scale");
    if (!value)
        return scale;
    if (value->is(Json::Kind::number))
        scale = glm::vec3(number_in(fields, "scale", 1.0f, {-kLargest, kLargest}, errors));
    else if (value->is(Json::Kind::array))
        fields.numbers("scale", 3, &scale.x);
    else
        report_wrong_type(*value, "element: \"scale\"", "a number or an array of three", errors);
    for (int axis = 0; axis < 3; ++axis) {
        if (scale[axis] == 0.0f) {
            out_of_range(*value, "element: \"scale\" is 0, which leaves nothing", errors);
            break;
        }
    }
    return scale;
}

/// T * Rx * Ry * Rz * S: about x, then about the turned y, then about the twice turned z.
glm::dmat4 read_placement(JsonFields& fields, Errors& errors)
{
    glm::dvec3 position(0.0);
    glm::vec3 degrees(0.0f);
    vector_of(fields, "position", position, false);
    vector_of(fields, "rotation_degrees", degrees, false);
    const glm::vec3 scale = read_scale(fields, errors);
    glm::dmat4 world = glm::translate(glm::dmat4(1.0), position);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 about(0.0);
        about[axis] = 1.0;
        world = glm::rotate(world, glm::radians(std::remainder(static_cast<double>(degrees[axis]), 360.0)), about);
    }
    return glm::scale(world, glm::dvec3(scale));
}

ElementEntry read_element(const Json& json, Errors& errors)
{
    JsonFields fields(json, "element", errors);
    ElementEntry element;
    element.where = json.where;
    element.name = fields.text("name");
    element.model = read_file_name(fields, "model", errors);
    if (element.name.empty())
        element.name = std::filesystem::path(element.model.path).stem().string();
    element.cell = read_cell(fields, errors);
    element.world_from_model = read_placement(fields, errors);
    fields.finish();
    return element;
}

SkyEntry read_sky(const Json& json, Errors& errors)
{
    JsonFields fields(json, "sky", errors);
    SkyEntry sky;
    sky.faces = read_file_name(fields, "faces", errors);
    sky.intensity = number_in(fields, "intensity", 1.0f, {0.0, kLargestColor}, errors);
    fields.finish();
    return sky;
}

/// Names are how the outside speaks of a thing, so those that the file writes differ within their list.
void report_twice(const Json& list, std::string_view what, Errors& errors)
{
    std::map<std::string, int> lines;
    for (const Json& entry : list.array) {
        const Json* name = entry.find("name");
        if (!name || !name->is(Json::Kind::string) || name->string.empty())
            continue;
        const auto [first, is_new] = lines.try_emplace(name->string, name->where.line);
        if (!is_new) {
            errors.push_back({"duplicate_name", fmt::format("two {} are called `{}`", what, name->string),
                              fmt::format("the first stands at line {}; rename one", first->second), name->where});
        }
    }
}

} // namespace

NamedFile read_file_name(JsonFields& fields, std::string_view key, Errors& errors)
{
    const Json* value = fields.require(key, Json::Kind::string);
    if (!value)
        return {};
    if (value->string.empty() || value->string.find('\0') != std::string::npos)
        out_of_range(*value, fmt::format("\"{}\" names no file", key), errors);
    const auto path = std::filesystem::path(value->where.file).parent_path() / value->string;
    return {value->string.empty() ? "" : path.string(), value->where};
}

float number_in(JsonFields& fields, std::string_view key, float fallback, Range range, Errors& errors)
{
    const Json* value = fields.find(key, Json::Kind::number);
    if (!value)
        return fallback;
    const auto number = static_cast<float>(value->number);
    const bool is_inside = range.is_open ? number > range.low && number < range.high
                                         : number >= range.low && number <= range.high;
    if (std::isfinite(number) && is_inside)
        return number;
    out_of_range(*value,
                 fmt::format("\"{}\" is {}, but should be {} {} and {} {}", key, value->number,
                             range.is_open ? "above" : "at least", range.low, range.is_open ? "below" : "at most",
                             range.high),
                 errors);
    return fallback;
}

bool vector_of(JsonFields& fields, std::string_view key, glm::vec3& out, bool is_required)
{
    if (is_required && !fields.require(key))
        return false;
    return fields.numbers(key, 3, &out.x);
}

bool vector_of(JsonFields& fields, std::string_view key, glm::dvec3& out, bool is_required)
{
    if (is_required && !fields.require(key))
        return false;
    return fields.numbers(key, 3, &out.x);
}

bool has_length(JsonFields& fields, std::string_view key, const glm::dvec3& vector, Errors& errors)
{
    if (glm::length(vector) > 0.0)
        return true;
    out_of_range(*fields.find(key), fmt::format("\"{}\" has length 0, so it points nowhere", key), errors);
    return false;
}

void out_of_range(const Json& value, std::string message, Errors& errors, std::string hint)
{
    errors.push_back({"value_out_of_range", std::move(message), std::move(hint), value.where});
}

Entries read_entries(const Json& root, Errors& errors)
{
    JsonFields fields(root, "scene", errors);
    Entries entries;
    fields.text("$schema");
    check_version(fields, errors);
    entries.name = fields.text("name", std::filesystem::path(root.where.file).stem().string());
    if (const Json* camera = fields.find("camera", Json::Kind::object))
        entries.camera = read_camera(*camera, errors);
    if (const Json* sky = fields.find("sky", Json::Kind::object))
        entries.sky = read_sky(*sky, errors);
    if (const Json* atlas = fields.find("atlas", Json::Kind::object))
        entries.atlas = read_atlas(*atlas, errors);
    if (const Json* elements = fields.find("elements", Json::Kind::array)) {
        for (const Json& element : elements->array)
            entries.elements.push_back(read_element(element, errors));
        report_twice(*elements, "elements", errors);
        check_cells(entries, errors);
    }
    if (const Json* lights = fields.find("lights", Json::Kind::array)) {
        for (const Json& light : lights->array)
            entries.lights.push_back(read_light(light, fmt::format("light {}", entries.lights.size()), errors));
        report_twice(*lights, "lights", errors);
    }
    fields.finish();
    return entries;
}

} // namespace passgraph::scene_file
