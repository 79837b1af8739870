// What a file's numbers mean to a signal, both ways.
#pragma once

#include <string>

#include <passgraph/core/error.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>

namespace passgraph::tool {

/// Reads a picture as values of a signal: codes of a display are decoded for radiance and albedo, taken as they are for
/// display, mask and material; alpha becomes premultiplied.
/// Errors   those of read_picture; codes_as_values for signals that no codes of a display can hold.
Result<Picture> read_values(const std::string& file, Signal signal);

/// Whether a file of this kind can hold the signal.
/// Errors   picture_format; radiance_to_png; values_to_png for normals and the like.
Result<void> check_file_holds(const std::string& file, Signal signal);

/// A signal's values as the numbers of the file: albedo is encoded, alpha becomes straight, in .png and .jpg.
Picture file_numbers(Picture values, const std::string& file, Signal signal);

} // namespace passgraph::tool
