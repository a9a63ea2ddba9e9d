#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "render/image/image.h"
#include "render/video/video_kind.h"

namespace mien::render {

/// Hashes of what went into a video while it was written, to check the file against. Similarity
/// only estimates, and fails for movements so slow that coding changes a frame by more than the
/// next frame differs from it; these hashes tell exactly (but for a chance of 2⁻⁶⁴) which frames
/// the encoder was given and which bytes of the file it made of each.
struct VideoReceipt {
  std::vector<std::uint64_t> frames;         ///< hash_of each frame that was written, in order
  std::vector<std::uint64_t> packet_hashes;  ///< of each frame; empty: no packet per frame
};

/// Whether files of that kind store each frame as one packet as the encoder made it: MP4, WebM and
/// Matroska do, animated pictures do not.
bool has_packet_per_frame(VideoKind kind);

/// Hash of all channels of a picture.
std::uint64_t hash_of(const Image8& picture);

/// Hash of the coded bytes of a frame (a packet) of a codec ("h264"), the same for what the encoder
/// made and for what the file holds: H.264 has marks between its units where MP4 has their lengths
/// (ISO/IEC 14496-15, of four bytes), and WebM leaves out the marks between AV1's frames.
/// `has_lengths`: as MP4 has it.
std::uint64_t packet_hash(std::string_view codec, std::span<const std::uint8_t> bytes,
                          bool has_lengths);

}  // namespace mien::render
