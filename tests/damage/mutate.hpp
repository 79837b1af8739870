// Damages files in the ways that editors, exporters and broken disks do; the same for a seed on every machine.
#pragma once

#include <random>
#include <string>
#include <string_view>

#include <passgraph/core/error.hpp>

namespace passgraph::test {

using Random = std::mt19937;

/// One damage to a JSON or GLSL text: a number made extreme, a word replaced by another of the text, a piece cut, doubled
/// or moved, a bracket lost, values nested a thousand deep, a random byte.
std::string damaged_text(std::string text, Random& random);

/// One damage to bytes: a bit or a 32-bit word changed, a piece cut or doubled, the end lost.
std::string damaged_bytes(std::string bytes, Random& random);

/// Fails the test unless every error has a code, a message, and a place that exists where it names `file`.
void check_errors(const Errors& errors, std::string_view text, const std::string& file);

} // namespace passgraph::test
