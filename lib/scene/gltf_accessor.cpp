// The numbers behind an accessor, whatever type they are stored as.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

template <class T>
double load(const unsigned char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value); // accessors need not be aligned for us
    return static_cast<double>(value);
}

double component(const unsigned char* bytes, int type)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return load<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return load<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return load<std::uint32_t>(bytes);
    default: return load<float>(bytes);
    }
}

/// glTF 2.0, section 3.11: signed values are max(c / largest, -1).
double normalized(double value, int type)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return std::max(value / 127.0, -1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return value / 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return std::max(value / 32767.0, -1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return value / 65535.0;
    default: return value;
    }
}

const unsigned char* bytes_at(const tinygltf::Model& model, int view, size_t offset)
{
    const tinygltf::BufferView& from = model.bufferViews[static_cast<size_t>(view)];
    return model.buffers[static_cast<size_t>(from.buffer)].data.data() + from.byteOffset + offset;
}

/// All components in one row, sparse replacements done; an accessor without a view holds zeros.
std::vector<double> read_all(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const auto components = static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    const size_t bytes = component_bytes(accessor.componentType);
    std::vector<double> values(accessor.count * components, 0.0);
    if (accessor.bufferView >= 0) {
        const size_t stride = model.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
        const size_t step = stride ? stride : components * bytes;
        const unsigned char* from = bytes_at(model, accessor.bufferView, accessor.byteOffset);
        for (size_t i = 0; i < accessor.count; ++i)
            for (size_t c = 0; c < components; ++c)
                values[i * components + c] = component(from + i * step + c * bytes, accessor.componentType);
    }
    if (accessor.sparse.isSparse) {
        const auto& sparse = accessor.sparse;
        const unsigned char* places =
            bytes_at(model, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset));
        const unsigned char* from =
            bytes_at(model, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset));
        const size_t index_bytes = component_bytes(sparse.indices.componentType);
        for (size_t i = 0; i < static_cast<size_t>(sparse.count); ++i) {
            const auto place = static_cast<size_t>(component(places + i * index_bytes, sparse.indices.componentType));
            if (place >= accessor.count)
                return {};
            for (size_t c = 0; c < components; ++c)
                values[place * components + c] =
                    component(from + (i * components + c) * bytes, accessor.componentType);
        }
    }
    return values;
}

} // namespace

std::optional<std::vector<float>> read_floats(const File& file, int accessor, Errors& errors)
{
    const tinygltf::Accessor& from = file.model.accessors[static_cast<size_t>(accessor)];
    const std::vector<double> values = read_all(file.model, from);
    const Location where = place_of(file, "accessors", accessor);
    if (values.empty()) {
        errors.push_back(malformed(where, fmt::format("accessors[{}]: a sparse index is not less than its count {}",
                                                      accessor, from.count)));
        return std::nullopt;
    }
    std::vector<float> floats(values.size());
    for (size_t i = 0; i < values.size(); ++i) {
        floats[i] = static_cast<float>(from.normalized ? normalized(values[i], from.componentType) : values[i]);
        if (!std::isfinite(floats[i])) {
            errors.push_back(malformed(where, fmt::format("accessors[{}]: element {} is not finite", accessor,
                                                          i / (values.size() / from.count))));
            return std::nullopt;
        }
    }
    return floats;
}

std::vector<std::uint32_t> read_indices(const File& file, int accessor)
{
    const std::vector<double> values = read_all(file.model, file.model.accessors[static_cast<size_t>(accessor)]);
    std::vector<std::uint32_t> indices(values.size());
    std::transform(values.begin(), values.end(), indices.begin(),
                   [](double value) { return static_cast<std::uint32_t>(value); });
    return indices;
}

} // namespace passgraph::gltf
