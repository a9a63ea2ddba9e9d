#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "render/image/image.h"
#include "render/video/video_kind.h"

namespace mien::render {

/// What went into a video while it was written, to hold the file against. Where likeness can only
/// estimate, in movements so slow that coding changes a frame by more than the next one differs
/// from it, these are exact but for a chance of 2⁻⁶⁴: which frames were given to the encoder, and
/// in which bytes each of them went into the file.
struct VideoReceipt {
  std::vector<std::uint64_t> frames;  ///< hash_of each frame that was written, in their order
  std::vector<std::uint64_t> coded;   ///< hash_of_coded each of them; empty unless codes_apart
};

/// Whether each frame of that kind has bytes of its own that files hold as the encoder made them:
/// those of MP4, WebM and Matroska, but not of animated pictures.
bool codes_apart(VideoKind kind);

/// Of every channel of a picture.
std::uint64_t hash_of(const Image8& picture);

/// Of the coded bytes of a frame (a packet) of a codec ("h264"), the same for what an encoder gave
/// and for what a file holds of it: H.264 has marks between its units where MP4 has their lengths
/// (ISO/IEC 14496-15, of four bytes), and WebM leaves out the marks between AV1's frames.
/// `has_lengths`: as MP4 has it.
std::uint64_t hash_of_coded(std::string_view codec, std::span<const std::uint8_t> bytes,
                            bool has_lengths);

}  // namespace mien::render
