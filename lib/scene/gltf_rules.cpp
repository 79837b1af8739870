// What type each field of a glTF file has and what its indices point into: one table, one walk.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

enum class Is {
    size,       ///< an integer from 0
    number,     ///< fits a float
    numbers,    ///< exactly `count`
    flag,
    text,
    texts,
    index,      ///< into the top-level array `of`
    indices,    ///< a list of them
    index_map,  ///< an object whose values are indices
    index_maps, ///< a list of those
    object,     ///< to which the rules of owner `of` apply
    objects     ///< a list of those
};

struct Rule {
    std::string_view owner;
    std::string_view key;
    Is is;
    std::string_view of = "";
    bool is_required = false;
    size_t count = 0;
};

constexpr bool kRequired = true;

// glTF 2.0 specification, chapter 5 (properties reference), as far as it is read here or by tinygltf.
constexpr Rule kRules[] = {
    {"root", "asset", Is::object, "asset", kRequired},
    {"root", "extensionsUsed", Is::texts},
    {"root", "extensionsRequired", Is::texts},
    {"root", "scene", Is::index, "scenes"},
    {"root", "scenes", Is::objects, "scene"},
    {"root", "nodes", Is::objects, "node"},
    {"root", "meshes", Is::objects, "mesh"},
    {"root", "accessors", Is::objects, "accessor"},
    {"root", "bufferViews", Is::objects, "bufferView"},
    {"root", "buffers", Is::objects, "buffer"},
    {"root", "materials", Is::objects, "material"},
    {"root", "textures", Is::objects, "texture"},
    {"root", "images", Is::objects, "image"},
    {"root", "samplers", Is::objects, "sampler"},
    {"root", "skins", Is::objects, "skin"},
    {"root", "cameras", Is::objects, "camera"},
    {"root", "animations", Is::objects, "animation"},
    {"asset", "version", Is::text, "", kRequired},
    {"scene", "name", Is::text},
    {"scene", "nodes", Is::indices, "nodes"},
    {"node", "name", Is::text},
    {"node", "children", Is::indices, "nodes"},
    {"node", "mesh", Is::index, "meshes"},
    {"node", "skin", Is::index, "skins"},
    {"node", "camera", Is::index, "cameras"},
    {"node", "matrix", Is::numbers, "", false, 16},
    {"node", "translation", Is::numbers, "", false, 3},
    {"node", "rotation", Is::numbers, "", false, 4},
    {"node", "scale", Is::numbers, "", false, 3},
    {"mesh", "name", Is::text},
    {"mesh", "primitives", Is::objects, "primitive", kRequired},
    {"primitive", "attributes", Is::index_map, "accessors", kRequired},
    {"primitive", "indices", Is::index, "accessors"},
    {"primitive", "material", Is::index, "materials"},
    {"primitive", "mode", Is::size},
    {"primitive", "targets", Is::index_maps, "accessors"},
    {"accessor", "bufferView", Is::index, "bufferViews"},
    {"accessor", "byteOffset", Is::size},
    {"accessor", "componentType", Is::size, "", kRequired},
    {"accessor", "normalized", Is::flag},
    {"accessor", "count", Is::size, "", kRequired},
    {"accessor", "type", Is::text, "", kRequired},
    {"accessor", "sparse", Is::object, "sparse"},
    {"sparse", "count", Is::size, "", kRequired},
    {"sparse", "indices", Is::object, "sparse indices", kRequired},
    {"sparse", "values", Is::object, "sparse values", kRequired},
    {"sparse indices", "bufferView", Is::index, "bufferViews", kRequired},
    {"sparse indices", "byteOffset", Is::size},
    {"sparse indices", "componentType", Is::size, "", kRequired},
    {"sparse values", "bufferView", Is::index, "bufferViews", kRequired},
    {"sparse values", "byteOffset", Is::size},
    {"bufferView", "buffer", Is::index, "buffers", kRequired},
    {"bufferView", "byteOffset", Is::size},
    {"bufferView", "byteLength", Is::size, "", kRequired},
    {"bufferView", "byteStride", Is::size},
    {"bufferView", "target", Is::size},
    {"buffer", "uri", Is::text},
    {"buffer", "byteLength", Is::size, "", kRequired},
    {"material", "name", Is::text},
    {"material", "doubleSided", Is::flag},
    {"material", "emissiveFactor", Is::numbers, "", false, 3},
    {"material", "emissiveTexture", Is::object, "textureInfo"},
    {"material", "normalTexture", Is::object, "textureInfo"},
    {"material", "occlusionTexture", Is::object, "textureInfo"},
    {"material", "pbrMetallicRoughness", Is::object, "pbr"},
    {"material", "extensions", Is::object, "material extensions"},
    {"pbr", "baseColorFactor", Is::numbers, "", false, 4},
    {"pbr", "metallicFactor", Is::number},
    {"pbr", "roughnessFactor", Is::number},
    {"pbr", "baseColorTexture", Is::object, "textureInfo"},
    {"pbr", "metallicRoughnessTexture", Is::object, "textureInfo"},
    {"material extensions", "KHR_materials_specular", Is::object, "specular"},
    {"material extensions", "KHR_materials_emissive_strength", Is::object, "emissive strength"},
    {"specular", "specularFactor", Is::number},
    {"emissive strength", "emissiveStrength", Is::number},
    {"textureInfo", "index", Is::index, "textures", kRequired},
    {"textureInfo", "texCoord", Is::size},
    {"texture", "name", Is::text},
    {"texture", "sampler", Is::index, "samplers"},
    {"texture", "source", Is::index, "images"},
    {"image", "name", Is::text},
    {"image", "uri", Is::text},
    {"image", "mimeType", Is::text},
    {"image", "bufferView", Is::index, "bufferViews"},
    {"sampler", "wrapS", Is::size},
    {"sampler", "wrapT", Is::size},
    {"skin", "inverseBindMatrices", Is::index, "accessors"},
    {"skin", "skeleton", Is::index, "nodes"},
    {"skin", "joints", Is::indices, "nodes", kRequired},
    {"animation", "channels", Is::objects, "channel", kRequired},
    {"animation", "samplers", Is::objects, "animation sampler", kRequired},
    {"channel", "target", Is::object, "channel target", kRequired},
    {"channel target", "node", Is::index, "nodes"},
    {"animation sampler", "input", Is::index, "accessors", kRequired},
    {"animation sampler", "output", Is::index, "accessors", kRequired},
};

constexpr double kLargestSize = 1099511627776.0; // 2^40: sums and products of two sizes by a stride fit 64 bits

class Walk {
public:
    explicit Walk(const Json& root) : root_(root) {}

    void object(const Json& value, std::string_view owner, const std::string& name)
    {
        if (!expect(value, Json::Kind::object, name))
            return;
        for (const Rule& rule : kRules) {
            if (rule.owner != owner)
                continue;
            const Json* member = value.find(rule.key);
            const std::string path = name.empty() ? std::string(rule.key) : fmt::format("{}.{}", name, rule.key);
            if (member)
                check(*member, rule, path);
            else if (rule.is_required)
                errors.push_back(malformed(value.where, fmt::format("\"{}\" is missing", path)));
        }
    }

    Errors errors;

private:
    bool expect(const Json& value, Json::Kind kind, const std::string& name)
    {
        if (value.is(kind))
            return true;
        wrong(value, name, kind_name(kind));
        return false;
    }

    void wrong(const Json& value, const std::string& name, std::string_view expected)
    {
        errors.push_back(malformed(value.where, fmt::format("\"{}\" should be {}, but is {}",
                                                            name.empty() ? "the file" : name, expected,
                                                            kind_name(value.kind))));
    }

    void check(const Json& value, const Rule& rule, const std::string& name)
    {
        switch (rule.is) {
        case Is::size: size(value, name); break;
        case Is::number: number(value, name); break;
        case Is::numbers: numbers(value, name, rule.count); break;
        case Is::flag: expect(value, Json::Kind::boolean, name); break;
        case Is::text: expect(value, Json::Kind::string, name); break;
        case Is::index: index(value, name, rule.of); break;
        case Is::index_map: map(value, name, rule.of); break;
        case Is::object: object(value, rule.of, name); break;
        case Is::texts:
        case Is::indices:
        case Is::index_maps:
        case Is::objects: list(value, rule, name); break;
        }
    }

    void list(const Json& value, const Rule& rule, const std::string& name)
    {
        if (!expect(value, Json::Kind::array, name))
            return;
        for (size_t i = 0; i < value.array.size(); ++i) {
            const std::string item = fmt::format("{}[{}]", name, i);
            if (rule.is == Is::texts)
                expect(value.array[i], Json::Kind::string, item);
            else if (rule.is == Is::indices)
                index(value.array[i], item, rule.of);
            else if (rule.is == Is::index_maps)
                map(value.array[i], item, rule.of);
            else
                object(value.array[i], rule.of, item);
        }
    }

    void map(const Json& value, const std::string& name, std::string_view of)
    {
        if (!expect(value, Json::Kind::object, name))
            return;
        for (const Json::Member& member : value.members)
            index(member.value, fmt::format("{}.{}", name, member.key), of);
    }

    void size(const Json& value, const std::string& name)
    {
        if (!value.is(Json::Kind::number))
            wrong(value, name, "an integer");
        else if (!value.is_integer || value.number < 0 || value.number > kLargestSize)
            errors.push_back(malformed(value.where, fmt::format("\"{}\" should be an integer from 0 to 2^40, but is {}",
                                                                name, value.number)));
    }

    void index(const Json& value, const std::string& name, std::string_view of)
    {
        const size_t before = errors.size();
        size(value, name);
        const Json* target = root_.find(of);
        const size_t count = target ? target->array.size() : 0;
        if (errors.size() == before && value.number >= static_cast<double>(count)) {
            errors.push_back(malformed(value.where, fmt::format("\"{}\" names {}[{}], but there are {} {}", name, of,
                                                                value.number, count, of)));
        }
    }

    void number(const Json& value, const std::string& name)
    {
        if (!value.is(Json::Kind::number))
            wrong(value, name, "a number");
        else if (!std::isfinite(static_cast<float>(value.number)))
            errors.push_back(malformed(value.where, fmt::format("\"{}\" is {}, which no float holds", name, value.number)));
    }

    void numbers(const Json& value, const std::string& name, size_t count)
    {
        if (!expect(value, Json::Kind::array, name))
            return;
        if (value.array.size() != count)
            errors.push_back(malformed(value.where, fmt::format("\"{}\" should have {} numbers, but has {}", name, count,
                                                                value.array.size())));
        for (size_t i = 0; i < value.array.size(); ++i)
            number(value.array[i], fmt::format("{}[{}]", name, i));
    }

    const Json& root_;
};

// Required extensions that change nothing we would get wrong.
constexpr std::string_view kKnownExtensions[] = {"KHR_materials_specular", "KHR_materials_emissive_strength",
                                                 "KHR_mesh_quantization"};

Errors check_extensions(const Json& root)
{
    Errors errors;
    for (const Json& name : entries_of(root, "extensionsRequired")) {
        if (std::find(std::begin(kKnownExtensions), std::end(kKnownExtensions), name.string) ==
            std::end(kKnownExtensions)) {
            errors.push_back(unsupported(name.where,
                                         fmt::format("the model requires the extension {}, which cannot be read",
                                                     name.string),
                                         "export the model without it"));
        }
    }
    return errors;
}

} // namespace

Errors check_rules(const Json& root)
{
    Walk walk(root);
    walk.object(root, "root", "");
    if (!walk.errors.empty())
        return walk.errors;
    const Json& version = *root.find("asset")->find("version");
    if (!version.string.starts_with("2."))
        return {malformed(version.where, fmt::format("this is glTF {}, only glTF 2 can be read", version.string))};
    return check_extensions(root);
}

} // namespace passgraph::gltf
