// Pictures in and out of files: what the numbers mean is decided by the file's kind and the signal asked for.
#pragma once

#include <array>
#include <string>

#include <passgraph/core/error.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph {

/// How the numbers of an 8- or 16-bit file are to be understood; .exr, .hdr and .pfm are always taken as they are.
enum class Transfer {
    decode_srgb, ///< radiance, albedo: color channels are decoded to linear, alpha is kept
    as_is        ///< display, mask and everything else: code / largest code
};

/// Reads a picture: .png .jpg .jpeg .hdr .exr .pfm (by content where the format has a magic number, else by suffix).
///
/// Shape    the file's extent; row 0 of the picture is the file's bottom row; 1 to 4 channels as in the file
///          (grey + alpha becomes 4 channels, rgb and grey keep theirs).
/// Units    codes / 255 or / 65535, decoded by IEC 61966-2-1 when asked; floats unchanged (NaN and infinity included).
/// Errors   file_missing, file_unreadable, picture_malformed (with the reader's reason), picture_too_large
///          (more than 16384 in a direction), picture_format (unknown suffix).
/// Cost     one read and one conversion.
Result<Picture> read_picture(const std::string& path, Transfer transfer);

/// The six files px nx py ny pz nz (any readable suffix) of a folder, as cube faces in the order +X -X +Y -Y +Z -Z.
///
/// Shape    six square pictures of 3 channels and equal extent, row 0 being the *top* row of the file,
///          as OpenGL's cube-map convention wants.
/// Errors   those of read_picture, plus file_missing naming each absent face, cube_face_size, cube_face_not_square.
Result<std::array<Picture, 6>> read_cube(const std::string& folder, Transfer transfer = Transfer::decode_srgb);

/// True when files with this suffix hold codes of the display (.png .jpg .jpeg), false for .exr .hdr .pfm.
/// Errors   picture_format for any other suffix.
Result<bool> holds_display_codes(const std::string& path);

/// Writes a picture; the suffix chooses the format. .png (8 bit) and .jpg clamp to [0, 1] and round to the nearest code
/// (a NaN is 0); .exr writes binary32, .pfm binary32 (1 or 3 channels), .hdr RGBE.
///
/// Two-channel pictures get a third channel of 0; alpha is dropped by .jpg, .hdr and .pfm.
/// The file is written beside the target and renamed, so a failure leaves the old file.
/// Errors   picture_format, file_unwritable.
Result<void> write_picture(const std::string& path, const Picture& picture);

/// The picture resampled to another extent with a smooth filter that clamps at the edges.
Picture resized(const Picture& picture, Extent extent);

} // namespace passgraph
