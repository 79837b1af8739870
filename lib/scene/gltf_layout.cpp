// Whether accessors lie inside their buffer views, and those inside their buffers.
#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr size_t kLargestStride = 252;

/// Sizes are at most 2^40 and strides at most 2^8, so nothing below can overflow 64 bits.
class Layout {
public:
    explicit Layout(const File& file)
        : file_(file), buffers_(entries_of(file.json, "buffers")), views_(entries_of(file.json, "bufferViews")),
          accessors_(entries_of(file.json, "accessors"))
    {
    }

    void check_buffers()
    {
        size_t total = 0;
        for (size_t i = 0; i < buffers_.size(); ++i) {
            const size_t length = size_or(buffers_[i], "byteLength", 0);
            total += length;
            if (length == 0)
                report(buffers_[i], fmt::format("buffers[{}] has no bytes", i));
            if (file_.is_binary && !buffers_[i].find("uri") && length > file_.binary_size) {
                report(buffers_[i], fmt::format("buffers[{}] has {} bytes, but the .glb file holds {}", i, length,
                                                file_.binary_size));
            }
        }
        if (total > Limits::kBufferBytes)
            errors.push_back(malformed(file_.json.find("buffers")->where,
                                       fmt::format("the buffers have {} bytes together; at most {} are read", total,
                                                   Limits::kBufferBytes)));
    }

    void check_views()
    {
        for (size_t i = 0; i < views_.size(); ++i) {
            const Json& view = views_[i];
            const size_t buffer = size_or(view, "buffer", 0);
            const size_t end = size_or(view, "byteOffset", 0) + size_or(view, "byteLength", 0);
            const size_t available = size_or(buffers_[buffer], "byteLength", 0);
            if (size_or(view, "byteLength", 0) == 0)
                report(view, fmt::format("bufferViews[{}] has no bytes", i));
            if (end > available) {
                report(view, fmt::format("bufferViews[{}] ends at byte {}, but buffers[{}] has {} bytes", i, end, buffer,
                                         available));
            }
            const size_t stride = size_or(view, "byteStride", 4);
            if (stride < 4 || stride > kLargestStride || stride % 4 != 0)
                report(view, fmt::format("bufferViews[{}]: a stride of {} bytes is no multiple of 4 from 4 to {}", i,
                                         stride, kLargestStride));
        }
    }

    void check_accessors()
    {
        for (size_t i = 0; i < accessors_.size(); ++i) {
            const Json& accessor = accessors_[i];
            const std::string name = fmt::format("accessors[{}]", i);
            const size_t component = component_bytes(static_cast<int>(size_or(accessor, "componentType", 0)));
            const size_t components = components_of(accessor.find("type")->string);
            const size_t count = size_or(accessor, "count", 0);
            if (component == 0)
                report(accessor, fmt::format("{}: componentType {} does not exist", name,
                                             size_or(accessor, "componentType", 0)));
            if (components == 0)
                report(accessor, fmt::format("{}: type \"{}\" does not exist", name, accessor.find("type")->string));
            if (count == 0 || count > Limits::kIndices)
                report(accessor, fmt::format("{} has {} elements; from 1 to {} are possible", name, count,
                                             Limits::kIndices));
            if (component == 0 || components == 0 || count == 0)
                continue;
            if (accessor.find("bufferView"))
                check_span(accessor, name, size_or(accessor, "bufferView", 0), count, component * components, true);
            if (const Json* sparse = accessor.find("sparse"))
                check_sparse(*sparse, name, count, component * components);
        }
    }

    Errors errors;

private:
    void report(const Json& at, std::string message) { errors.push_back(malformed(at.where, std::move(message))); }

    void check_span(const Json& from, const std::string& name, size_t view, size_t count, size_t element,
                    bool may_have_stride)
    {
        const size_t stride = may_have_stride ? size_or(views_[view], "byteStride", element) : element;
        const size_t end = size_or(from, "byteOffset", 0) + (count - 1) * stride + element;
        const size_t available = size_or(views_[view], "byteLength", 0);
        if (end > available) {
            report(from, fmt::format("{} ends at byte {} of bufferViews[{}], which has {} bytes", name, end, view,
                                     available));
        }
        if (stride < element)
            report(from, fmt::format("{}: its elements of {} bytes overlap at a stride of {}", name, element, stride));
    }

    void check_sparse(const Json& sparse, const std::string& owner, size_t owner_count, size_t element)
    {
        const std::string name = owner + ".sparse";
        const size_t count = size_or(sparse, "count", 0);
        const Json& indices = *sparse.find("indices");
        const Json& values = *sparse.find("values");
        const auto type = static_cast<int>(size_or(indices, "componentType", 0));
        if (count == 0 || count > owner_count) {
            report(sparse, fmt::format("{} replaces {} elements of {}", name, count, owner_count));
            return;
        }
        if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
            type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            report(indices, fmt::format("{}.indices: componentType {} is no unsigned integer", name, type));
            return;
        }
        check_span(indices, name + ".indices", size_or(indices, "bufferView", 0), count, component_bytes(type), false);
        check_span(values, name + ".values", size_or(values, "bufferView", 0), count, element, false);
    }

    const File& file_;
    const std::vector<Json>& buffers_;
    const std::vector<Json>& views_;
    const std::vector<Json>& accessors_;
};

} // namespace

size_t component_bytes(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
    default: return 0;
    }
}

size_t components_of(std::string_view type)
{
    if (type == "SCALAR")
        return 1;
    if (type == "VEC2")
        return 2;
    if (type == "VEC3")
        return 3;
    if (type == "VEC4" || type == "MAT2")
        return 4;
    if (type == "MAT3")
        return 9;
    return type == "MAT4" ? 16 : 0;
}

Errors check_layout(const File& file)
{
    Layout layout(file);
    layout.check_buffers();
    layout.check_views();
    if (layout.errors.empty())
        layout.check_accessors();
    return layout.errors;
}

} // namespace passgraph::gltf
