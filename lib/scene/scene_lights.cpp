// The "lights" of a scene file.
#include <limits>

#include <fmt/format.h>

#include "scene_fields.hpp"

namespace passgraph::scene_file {
namespace {

constexpr double kLargest = std::numeric_limits<float>::max();

void read_color(JsonFields& fields, Light& light, Errors& errors)
{
    if (!vector_of(fields, "color", light.color, true))
        return;
    for (int c = 0; c < 3; ++c) {
        if (light.color[c] < 0.0f || light.color[c] > kLargestColor) {
            out_of_range(fields.find("color")->array[static_cast<size_t>(c)],
                         fmt::format("light: a \"color\" of {} is outside 0 to {}", light.color[c], kLargestColor), errors);
        }
    }
}

void read_directional(JsonFields& fields, Light& light, Errors& errors)
{
    light.kind = Light::Kind::directional;
    if (vector_of(fields, "direction", light.direction, true) &&
        has_length(fields, "direction", light.direction, errors))
        light.direction = glm::vec3(glm::normalize(glm::dvec3(light.direction)));
}

void read_point(JsonFields& fields, Light& light, Errors& errors)
{
    light.kind = Light::Kind::point;
    vector_of(fields, "position", light.position, true);
    if (fields.require("radius"))
        light.radius = number_in(fields, "radius", 1.0f, {0.0, kLargest, true}, errors);
}

/// Half a cone's opening, from its axis: degrees in the file, radians in the light.
float read_angle(JsonFields& fields, std::string_view key, Errors& errors)
{
    constexpr double kHalfTurn = 180.0;
    return static_cast<float>(
        glm::radians(static_cast<double>(number_in(fields, key, 0.0f, {0.0, kHalfTurn}, errors))));
}

void read_spot(JsonFields& fields, Light& light, Errors& errors)
{
    read_point(fields, light, errors);
    read_directional(fields, light, errors);
    light.kind = Light::Kind::spot;
    light.inner_angle = read_angle(fields, "inner_angle_degrees", errors);
    if (!fields.require("outer_angle_degrees", Json::Kind::number))
        return;
    light.outer_angle = read_angle(fields, "outer_angle_degrees", errors);
    if (light.outer_angle < light.inner_angle)
        out_of_range(*fields.find("outer_angle_degrees"),
                     fmt::format("light: \"outer_angle_degrees\" is less than \"inner_angle_degrees\", {}",
                                 fields.find("inner_angle_degrees")->number),
                     errors, "light fades from the inner angle to the outer; equal angles give a sharp edge");
    if (light.outer_angle == 0.0f && fields.find("outer_angle_degrees")->number == 0.0)
        out_of_range(*fields.find("outer_angle_degrees"), "light: a cone of 0 degrees lets no light out", errors,
                     "angles are measured from the axis, so 30 is a cone that opens 60 degrees");
}

} // namespace

Light read_light(const Json& json, std::string fallback_name, Errors& errors)
{
    JsonFields fields(json, "light", errors);
    Light light;
    light.name = fields.text("name");
    if (light.name.empty())
        light.name = std::move(fallback_name);
    read_color(fields, light, errors);
    const Json* kind = fields.require("kind", Json::Kind::string);
    if (!kind)
        return light; // which further fields it may have depends on the kind
    if (kind->string == "directional") {
        read_directional(fields, light, errors);
    } else if (kind->string == "point") {
        read_point(fields, light, errors);
    } else if (kind->string == "spot") {
        read_spot(fields, light, errors);
    } else {
        out_of_range(*kind, fmt::format("light: \"kind\" is \"{}\"", kind->string), errors,
                     suggest(kind->string, {"directional", "point", "spot"}, "kinds"));
        return light;
    }
    fields.finish();
    return light;
}

} // namespace passgraph::scene_file
