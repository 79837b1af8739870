// One glTF primitive as indexed triangles with positions, normals and texture coordinates.
#include <algorithm>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr int kNone = -1;

/// What is wrong is said with the primitive's name, at the accessor's place.
class Reader {
public:
    Reader(const File& file, int mesh, size_t primitive, Errors& errors)
        : file_(file), errors_(errors), name_(fmt::format("meshes[{}].primitives[{}]", mesh, primitive)),
          primitive_(file.model.meshes[static_cast<size_t>(mesh)].primitives[primitive])
    {
    }

    int attribute(const std::string& name) const
    {
        const auto found = primitive_.attributes.find(name);
        return found == primitive_.attributes.end() ? kNone : found->second;
    }

    const tinygltf::Accessor& accessor(int index) const { return file_.model.accessors[static_cast<size_t>(index)]; }

    /// False, with a report, unless the accessor has this type and as many elements as there are vertices.
    bool fits(const std::string& attribute_name, int index, int type, size_t count)
    {
        if (accessor(index).type != type)
            return report(index, fmt::format("{}: {} has the wrong type", name_, attribute_name));
        if (accessor(index).count != count) {
            return report(index, fmt::format("{}: {} has {} elements, POSITION has {}", name_, attribute_name,
                                             accessor(index).count, count));
        }
        return count <= Limits::kVertices ||
               report(index, fmt::format("{}: {} vertices; at most {} are read", name_, count, Limits::kVertices));
    }

    /// The corners in drawing order, before strips and fans are taken apart.
    std::optional<std::vector<std::uint32_t>> corners(size_t vertex_count)
    {
        const int index = primitive_.indices;
        if (index < 0) {
            std::vector<std::uint32_t> every(vertex_count);
            for (size_t i = 0; i < vertex_count; ++i)
                every[i] = static_cast<std::uint32_t>(i);
            return every;
        }
        const int type = accessor(index).componentType;
        const bool is_unsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                 type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (accessor(index).type != TINYGLTF_TYPE_SCALAR || !is_unsigned) {
            report(index, fmt::format("{}: its indices are no unsigned integers", name_));
            return std::nullopt;
        }
        std::vector<std::uint32_t> indices = read_indices(file_, index);
        for (size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] >= vertex_count) {
                report(index, fmt::format("{}: index {} names vertex {}, but there are {}", name_, i, indices[i],
                                          vertex_count));
                return std::nullopt;
            }
        }
        return indices;
    }

    bool report(int index, std::string message)
    {
        errors_.push_back(malformed(place_of(file_, "accessors", index), std::move(message)));
        return false;
    }

    const tinygltf::Primitive& primitive() const { return primitive_; }

private:
    const File& file_;
    Errors& errors_;
    std::string name_;
    const tinygltf::Primitive& primitive_;
};

/// Triangles as glTF 2.0, section 3.7.2.1, orders their corners; one with a repeated corner covers nothing and goes.
std::vector<std::uint32_t> triangles(const std::vector<std::uint32_t>& corners, int mode)
{
    std::vector<std::uint32_t> indices;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && a != c)
            indices.insert(indices.end(), {a, b, c});
    };
    const size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (size_t i = 0; i + 2 < corners.size(); i += step) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            add(corners[i + 1], corners[i + 2], corners[0]);
        else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1)
            add(corners[i], corners[i + 2], corners[i + 1]);
        else
            add(corners[i], corners[i + 1], corners[i + 2]);
    }
    return indices;
}

/// Twice the triangle's area along its normal. In double: squares of float positions overflow a float.
glm::dvec3 area_normal(const std::vector<Vertex>& vertices, const std::uint32_t* corner)
{
    const glm::dvec3 a = vertices[corner[0]].position;
    return glm::cross(glm::dvec3(vertices[corner[1]].position) - a, glm::dvec3(vertices[corner[2]].position) - a);
}

glm::vec3 unit_or_up(const glm::dvec3& normal)
{
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Flat shading needs a vertex per corner.
void unshare_with_flat_normals(Mesh& mesh)
{
    std::vector<Vertex> corners;
    corners.reserve(mesh.indices.size());
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 normal = unit_or_up(area_normal(mesh.vertices, &mesh.indices[i]));
        for (size_t k = 0; k < 3; ++k) {
            corners.push_back(mesh.vertices[mesh.indices[i + k]]);
            corners.back().normal = normal;
        }
    }
    mesh.vertices = std::move(corners);
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        mesh.indices[i] = static_cast<std::uint32_t>(i);
}

/// Normals to length 1; a zero one becomes the area-weighted normal of the faces around it.
void repair_normals(Mesh& mesh)
{
    std::vector<glm::dvec3> around(mesh.vertices.size(), glm::dvec3(0.0));
    const auto is_zero = [](const Vertex& vertex) { return vertex.normal == glm::vec3(0.0f); };
    if (std::any_of(mesh.vertices.begin(), mesh.vertices.end(), is_zero)) {
        for (size_t i = 0; i < mesh.indices.size(); i += 3)
            for (size_t k = 0; k < 3; ++k)
                around[mesh.indices[i + k]] += area_normal(mesh.vertices, &mesh.indices[i]);
    }
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertices[i].normal = unit_or_up(is_zero(mesh.vertices[i]) ? around[i] : glm::dvec3(mesh.vertices[i].normal));
}

} // namespace

std::optional<Mesh> read_primitive(const File& file, int mesh, size_t primitive, int uv_set, Errors& errors)
{
    Reader reader(file, mesh, primitive, errors);
    const int mode = reader.primitive().mode;
    const int position = reader.attribute("POSITION");
    if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN || position == kNone)
        return std::nullopt; // points, lines, or nothing that has a place
    const size_t count = reader.accessor(position).count;
    const int normal = reader.attribute("NORMAL");
    const int uv = reader.attribute(fmt::format("TEXCOORD_{}", uv_set));
    bool fits = reader.fits("POSITION", position, TINYGLTF_TYPE_VEC3, count);
    fits = (normal == kNone || reader.fits("NORMAL", normal, TINYGLTF_TYPE_VEC3, count)) && fits;
    fits = (uv == kNone || reader.fits("TEXCOORD", uv, TINYGLTF_TYPE_VEC2, count)) && fits;
    if (!fits)
        return std::nullopt;
    const auto corners = reader.corners(count);
    const auto positions = read_floats(file, position, errors);
    const auto normals = normal == kNone ? std::vector<float>{} : read_floats(file, normal, errors);
    const auto uvs = uv == kNone ? std::vector<float>{} : read_floats(file, uv, errors);
    if (!corners || !positions || !normals || !uvs)
        return std::nullopt;

    Mesh result;
    result.name = file.model.meshes[static_cast<size_t>(mesh)].name;
    result.indices = triangles(*corners, mode);
    if (result.indices.empty())
        return std::nullopt;
    result.vertices.resize(count);
    for (size_t i = 0; i < count; ++i) {
        Vertex& vertex = result.vertices[i];
        vertex.position = {(*positions)[3 * i], (*positions)[3 * i + 1], (*positions)[3 * i + 2]};
        if (!normals->empty())
            vertex.normal = {(*normals)[3 * i], (*normals)[3 * i + 1], (*normals)[3 * i + 2]};
        if (!uvs->empty())
            vertex.uv = {(*uvs)[2 * i], (*uvs)[2 * i + 1]};
    }
    if (normals->empty())
        unshare_with_flat_normals(result);
    else
        repair_normals(result);
    return result;
}

} // namespace passgraph::gltf
