// Letters as filled rectangles.
#include "label.hpp"

#include <algorithm>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

void draw_label(passgraph::Picture& picture, std::string text, int left, int top, const std::array<float, 3>& color)
{
    constexpr int kScale = 2;
    struct Corner {
        float x, y, z;
        unsigned char rgba[4];
    };
    std::vector<Corner> corners(text.size() * 80 + 4); // a letter has at most 20 rectangles
    const int rectangles = stb_easy_font_print(0.0f, 0.0f, text.data(), nullptr, corners.data(),
                                               static_cast<int>(corners.size() * sizeof(Corner)));
    for (int i = 0; i < rectangles; ++i) {
        const Corner& low = corners[static_cast<size_t>(i) * 4];
        const Corner& high = corners[static_cast<size_t>(i) * 4 + 2];
        const int first_x = std::max(left + static_cast<int>(low.x) * kScale, 0);
        const int last_x = std::min(left + static_cast<int>(high.x) * kScale, picture.extent.width);
        const int first_y = std::max(top + static_cast<int>(low.y) * kScale, 0);
        const int last_y = std::min(top + static_cast<int>(high.y) * kScale, picture.extent.height);
        for (int y = first_y; y < last_y; ++y)
            for (int x = first_x; x < last_x; ++x)
                for (int c = 0; c < 3; ++c)
                    picture.at(x, picture.extent.height - 1 - y, c) = color[static_cast<size_t>(c)];
    }
}
