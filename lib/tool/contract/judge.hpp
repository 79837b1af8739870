// Looks at pictures texel by texel: finite, in range, the same.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <passgraph/core/contract.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>

namespace passgraph::tool::contract {

using Outputs = std::map<std::string, Picture>;

struct Texel {
    int x = 0;
    int y = 0;
};

/// The first texel, row by row, that `is_bad`.
template <class IsBad>
std::optional<Texel> find_texel(const Picture& picture, const IsBad& is_bad)
{
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            if (is_bad(Texel{x, y}))
                return Texel{x, y};
    return std::nullopt;
}

bool is_finite(const Picture& picture, Texel texel);
bool is_all_finite(const Outputs& outputs);
bool is_zero(const Picture& picture, Texel texel);
/// Inside the range, up to the rounding of values.hpp of numbers of this size; a normal has length 1 within 1e-3. False for NaN.
bool is_in_range(const Picture& picture, Texel texel, Signal signal, const Contract::Span& range, double size);
/// The largest finite component, sign apart.
double largest_of(const Picture& picture);
/// Bit for bit.
bool is_same(const Picture& a, const Picture& b, Texel texel);

std::string place_text(const std::string& output, Texel texel, Extent extent);
std::string texel_text(const Picture& picture, Texel texel);
std::string range_text(Signal signal, const Contract::Span& range);

} // namespace passgraph::tool::contract
