// A bounds-checked walk over an OpenEXR file's header and chunks.
//
// Source   "OpenEXR File Layout", openexr.com.
#include "image/exr_layout.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>
#include <tinyexr.h>

namespace passgraph::image_io
{

namespace
{

/// Takes numbers and names off the front of some bytes; once they run out everything is 0 and `is_good` false.
class Reader
{
public:
    explicit Reader(Bytes bytes, size_t position = 0) : bytes_(bytes), position_(position) {}

    template <class Number> Number take()
    {
        Number number{};
        if (const Bytes raw = take(sizeof number); is_good_)
            std::memcpy(&number, raw.data(), sizeof number);
        return number;
    }
    Bytes take(size_t count)
    {
        is_good_ = is_good_ && position_ <= bytes_.size() && count <= bytes_.size() - position_;
        if (!is_good_)
            return {};
        position_ += count;
        return bytes_.subspan(position_ - count, count);
    }
    std::string take_name()
    {
        std::string name;
        while (const char letter = take<char>())
            name += letter;
        return name;
    }
    bool is_good() const { return is_good_; }
    size_t position() const { return position_; }

private:
    Bytes bytes_;
    size_t position_;
    bool is_good_ = true;
};

tl::unexpected<std::string> reason(std::string text)
{
    return tl::unexpected<std::string>(std::move(text));
}

/// True when the list is well formed and ends where its attribute does.
bool read_channels(Bytes value, std::vector<ExrChannel>& channels)
{
    Reader reader(value);
    while (reader.is_good()) {
        ExrChannel channel;
        channel.name = reader.take_name();
        if (channel.name.empty())
            break;
        channel.type = reader.take<int32_t>();
        reader.take(4); // a hint for lossy compression, and padding
        channel.x_sampling = reader.take<int32_t>();
        channel.y_sampling = reader.take<int32_t>();
        const bool has_known_type = channel.type >= TINYEXR_PIXELTYPE_UINT && channel.type <= TINYEXR_PIXELTYPE_FLOAT;
        if (!has_known_type || channel.name.size() > 255 || channels.size() >= 1024)
            return false;
        channels.push_back(std::move(channel));
    }
    return reader.is_good() && reader.position() == value.size() && !channels.empty();
}

/// Takes up one attribute; a sentence when it is wrong. Unknown attributes are fine.
std::string read_attribute(const std::string& name, Bytes value, ExrLayout& layout)
{
    Reader reader(value);
    if (name == "channels") {
        if (!layout.channels.empty() || !read_channels(value, layout.channels))
            return "its list of channels is malformed";
    } else if (name == "compression") {
        layout.compression = reader.take<uint8_t>();
        if (value.size() != 1 || layout.compression > TINYEXR_COMPRESSIONTYPE_PIZ)
            return fmt::format("its compression {} is not supported (none, rle, zips, zip and piz are)",
                               layout.compression);
    } else if (name == "dataWindow") {
        layout.min_x = reader.take<int32_t>();
        layout.min_y = reader.take<int32_t>();
        layout.width = reader.take<int32_t>() - layout.min_x + 1;
        layout.height = reader.take<int32_t>() - layout.min_y + 1;
        if (value.size() != 16 || layout.width < 1 || layout.height < 1)
            return "its data window is empty";
    } else if (name == "tiles" && layout.is_tiled) {
        layout.tile_width = reader.take<uint32_t>();
        layout.tile_height = reader.take<uint32_t>();
        const int mode = reader.take<uint8_t>() & 15;
        const bool has_size = layout.tile_width >= 1 && layout.tile_height >= 1 &&
                              std::max(layout.tile_width, layout.tile_height) <= kLargestSide;
        if (value.size() != 9 || !has_size || mode > TINYEXR_TILE_RIPMAP_LEVELS)
            return "its tiles are malformed";
    }
    return {};
}

int64_t texel_bytes(const ExrLayout& layout)
{
    int64_t size = 0;
    for (const ExrChannel& channel : layout.channels)
        size += channel.type == TINYEXR_PIXELTYPE_HALF ? 2 : 4;
    return size;
}

int rows_per_chunk(int compression)
{
    switch (compression) {
    case TINYEXR_COMPRESSIONTYPE_ZIP:
        return 16;
    case TINYEXR_COMPRESSIONTYPE_PIZ:
        return 32;
    default:
        return 1;
    }
}

/// PIZ data: the range of a bitmap, the bitmap, a length, then as many bytes of Huffman code with a header of 20.
bool is_piz(Bytes data)
{
    Reader reader(data);
    const int first = reader.take<uint16_t>();
    const int last = reader.take<uint16_t>();
    if (last >= 8192)
        return false;
    if (first <= last)
        reader.take(static_cast<size_t>(last - first + 1));
    const int32_t length = reader.take<int32_t>();
    return length >= 20 && !reader.take(static_cast<size_t>(length)).empty();
}

bool is_plausible(Bytes data, int compression, size_t raw)
{
    if (data.size() == raw)
        return true; // stored raw
    if (data.empty() || data.size() > raw || compression == TINYEXR_COMPRESSIONTYPE_NONE)
        return false;
    return compression == TINYEXR_COMPRESSIONTYPE_PIZ ? is_piz(data) : data.size() > 2;
}

/// Where a chunk has to say that it is, and how many texels it then holds.
struct Chunk {
    std::vector<int32_t> place; ///< y, or tile x, tile y, level x, level y
    int64_t texels;
};

Chunk chunk_at(const ExrLayout& layout, int64_t column, int64_t row)
{
    if (layout.is_tiled)
        return {{static_cast<int32_t>(column), static_cast<int32_t>(row), 0, 0},
                std::min(layout.tile_width, layout.width - column * layout.tile_width) *
                    std::min(layout.tile_height, layout.height - row * layout.tile_height)};
    const int64_t rows = rows_per_chunk(layout.compression);
    return {{static_cast<int32_t>(layout.min_y + row * rows)},
            layout.width * std::min(rows, layout.height - row * rows)};
}

std::optional<std::string> find_chunk_fault(Bytes bytes, size_t offset, const Chunk& chunk, const ExrLayout& layout)
{
    if (offset < layout.table)
        return "it was not written to its end";
    Reader reader(bytes, offset);
    bool is_in_place = true;
    for (const int32_t coordinate : chunk.place)
        is_in_place = reader.take<int32_t>() == coordinate && is_in_place;
    const int32_t size = reader.take<int32_t>();
    const Bytes data = reader.take(size < 0 ? SIZE_MAX : static_cast<size_t>(size));
    if (!reader.is_good())
        return "the file ends before the picture does";
    const auto raw = static_cast<size_t>(chunk.texels * texel_bytes(layout));
    if (!is_in_place || !is_plausible(data, layout.compression, raw))
        return "a block of its pixels is malformed";
    return std::nullopt;
}

} // namespace

tl::expected<ExrLayout, std::string> read_exr_layout(Bytes bytes)
{
    constexpr uint32_t kTiled = 0x200;
    constexpr uint32_t kLongNames = 0x400;
    Reader reader(bytes);
    reader.take<uint32_t>(); // the magic number
    const auto version = reader.take<uint32_t>();
    if (!reader.is_good())
        return reason("the file ends inside its header");
    if ((version & 0xff) != 2)
        return reason(fmt::format("it has version {} of the format, and only 2 is known", version & 0xff));
    if ((version & ~(0xffu | kTiled | kLongNames)) != 0)
        return reason("files of several parts or of deep pixels are not supported");
    ExrLayout layout;
    layout.is_tiled = (version & kTiled) != 0;
    while (reader.is_good()) {
        const std::string name = reader.take_name();
        if (name.empty())
            break;
        reader.take_name(); // its type
        const Bytes value = reader.take(reader.take<uint32_t>());
        if (!reader.is_good())
            break;
        if (std::string wrong = read_attribute(name, value, layout); !wrong.empty())
            return reason(std::move(wrong));
    }
    if (!reader.is_good())
        return reason("the file ends inside its header");
    if (layout.channels.empty() || layout.compression < 0 || layout.width == 0 ||
        (layout.is_tiled && layout.tile_width == 0))
        return reason("its header lacks one of channels, compression, dataWindow and tiles");
    layout.table = reader.position();
    return layout;
}

std::optional<std::string> find_exr_fault(Bytes bytes, const ExrLayout& layout)
{
    const auto divided = [](int64_t size, int64_t by) { return (size + by - 1) / by; };
    const int64_t columns = layout.is_tiled ? divided(layout.width, layout.tile_width) : 1;
    const int64_t rows =
        divided(layout.height, layout.is_tiled ? layout.tile_height : rows_per_chunk(layout.compression));
    Reader table(bytes, layout.table);
    for (int64_t row = 0; row < rows; ++row) {
        for (int64_t column = 0; column < columns; ++column) {
            const auto offset = table.take<uint64_t>();
            if (!table.is_good())
                return "the file ends before the picture does";
            if (auto fault = find_chunk_fault(bytes, offset, chunk_at(layout, column, row), layout))
                return fault;
        }
    }
    return std::nullopt;
}

} // namespace passgraph::image_io
