// The node hierarchy: that it is a forest, and where each drawn node is.
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr int kNone = -1;

/// The parent of each node; reports a node that is a child twice.
std::vector<int> parents_of(const std::vector<Json>& nodes, Errors& errors)
{
    std::vector<int> parents(nodes.size(), kNone);
    for (size_t i = 0; i < nodes.size(); ++i) {
        for (const Json& child : entries_of(nodes[i], "children")) {
            int& parent = parents[static_cast<size_t>(child.number)];
            if (parent != kNone) {
                errors.push_back(malformed(child.where, fmt::format("nodes[{}] has two parents: nodes[{}] and nodes[{}]",
                                                                    child.number, parent, i)));
            }
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

/// Every node has one parent at most, so a walk upwards either ends or comes back to where it was.  O(nodes).
void find_cycle(const std::vector<Json>& nodes, const std::vector<int>& parents, Errors& errors)
{
    std::vector<int> seen_by(nodes.size(), kNone);
    for (size_t i = 0; i < nodes.size(); ++i) {
        const int walker = static_cast<int>(i);
        int node = walker;
        while (node != kNone && seen_by[static_cast<size_t>(node)] == kNone) {
            seen_by[static_cast<size_t>(node)] = walker;
            node = parents[static_cast<size_t>(node)];
        }
        if (node != kNone && seen_by[static_cast<size_t>(node)] == walker) {
            errors.push_back(malformed(nodes[static_cast<size_t>(node)].where,
                                       fmt::format("nodes[{}] is its own ancestor: the nodes form a cycle", node)));
        }
    }
}

void check_scene_roots(const Json& root, const std::vector<int>& parents, Errors& errors)
{
    const auto& scenes = entries_of(root, "scenes");
    for (size_t i = 0; i < scenes.size(); ++i) {
        std::vector<bool> is_listed(parents.size(), false);
        for (const Json& node : entries_of(scenes[i], "nodes")) {
            const auto index = static_cast<size_t>(node.number);
            if (parents[index] != kNone)
                errors.push_back(malformed(node.where, fmt::format("scenes[{}] names nodes[{}], which is no root: it is "
                                                                   "a child of nodes[{}]", i, index, parents[index])));
            if (is_listed[index])
                errors.push_back(malformed(node.where, fmt::format("scenes[{}] names nodes[{}] twice", i, index)));
            is_listed[index] = true;
        }
    }
}

glm::dmat4 parent_from_node(const File& file, int index, Errors& errors)
{
    const tinygltf::Node& node = file.model.nodes[static_cast<size_t>(index)];
    const auto report = [&](const char* what) {
        errors.push_back(malformed(place_of(file, "nodes", index), fmt::format("nodes[{}]: {}", index, what)));
        return glm::dmat4(1.0);
    };
    if (node.matrix.size() == 16) {
        const glm::dmat4 matrix = glm::make_mat4(node.matrix.data());
        const bool is_affine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
        return is_affine ? matrix : report("its matrix is not affine: the last row is not 0 0 0 1");
    }
    glm::dmat4 matrix(1.0);
    if (node.rotation.size() == 4) {
        const glm::dquat turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (glm::length(turn) == 0.0)
            return report("its rotation is the zero quaternion");
        matrix = glm::mat4_cast(glm::normalize(turn));
    }
    if (node.scale.size() == 3)
        for (int axis = 0; axis < 3; ++axis)
            matrix[axis] *= node.scale[static_cast<size_t>(axis)];
    if (node.translation.size() == 3)
        matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    return matrix;
}

std::vector<int> roots_to_draw(const File& file)
{
    const tinygltf::Model& model = file.model;
    if (!model.scenes.empty()) {
        // Without "scene" the choice is ours; the first is what exporters mean.
        const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
        return model.scenes[static_cast<size_t>(scene)].nodes;
    }
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            is_child[static_cast<size_t>(child)] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (!is_child[i])
            roots.push_back(static_cast<int>(i));
    return roots;
}

} // namespace

Errors check_nodes(const Json& root)
{
    Errors errors;
    const auto& nodes = entries_of(root, "nodes");
    const std::vector<int> parents = parents_of(nodes, errors);
    find_cycle(nodes, parents, errors);
    check_scene_roots(root, parents, errors);
    return errors;
}

std::vector<DrawnNode> drawn_nodes(const File& file, Errors& errors)
{
    std::vector<DrawnNode> drawn;
    const std::vector<int> roots = roots_to_draw(file);
    std::vector<DrawnNode> open; // a stack of our own: a chain of a million nodes is legal
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        open.push_back({*root, parent_from_node(file, *root, errors)});
    while (!open.empty()) {
        const DrawnNode next = open.back();
        open.pop_back();
        const tinygltf::Node& node = file.model.nodes[static_cast<size_t>(next.node)];
        if (node.mesh >= 0)
            drawn.push_back(next);
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            open.push_back({*child, next.root_from_node * parent_from_node(file, *child, errors)});
    }
    return drawn;
}

} // namespace passgraph::gltf
