// Words in a picture.
#pragma once

#include <array>
#include <string>

#include <passgraph/core/picture.hpp>

/// Draws a line of text, 14 texels high, its top left corner at a place from the picture's own top left.
/// Shape    `picture` has 3 channels; letters outside it are cut off.
/// Source   stb_easy_font's letters, twice their size.
void draw_label(passgraph::Picture& picture, std::string text, int left, int top, const std::array<float, 3>& color);
