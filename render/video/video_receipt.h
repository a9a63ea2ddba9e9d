#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "render/image/image.h"
#include "render/video/video_kind.h"

namespace mien::render {

/// What a film's sound was encoded to, recorded while it is written.
struct SoundReceipt {
  std::uint64_t hash = 0;                    ///< hash_of the sound that the encoder was given
  std::vector<std::uint64_t> packet_hashes;  ///< packet_hash of each packet, in order
};

/// Hashes of a video's frames and packets, recorded while it is written, to check the file against.
/// The similarity of decoded and rendered frames cannot distinguish frames of movements so slow
/// that lossy coding changes a frame by more than it differs from the next one; these hashes
/// identify exactly (except with probability 2⁻⁶⁴) which frames the encoder was given and which
/// bytes of the file it produced for each.
struct VideoReceipt {
  std::vector<std::uint64_t> frames;  ///< hash_of each written frame, in order
  /// The packet_hash of each frame; empty for kinds without a packet per frame.
  std::vector<std::uint64_t> packet_hashes;
  std::optional<SoundReceipt> sound;  ///< of a video with sound
};

/// Whether files of this kind store each frame as one packet, as the encoder produced it: MP4, WebM
/// and Matroska do, animated pictures do not.
bool has_packet_per_frame(VideoKind kind);

/// Hash of all channels of a picture.
std::uint64_t hash_of(const Image8& picture);

/// Returns the hash of a frame's coded bytes (a packet) for a codec ("h264"). It is the same for
/// the encoder's packet and the file's: H.264 NAL units are hashed without their separators, which
/// are start codes (Annex B) in the encoder's output and length prefixes of four bytes in MP4
/// (ISO/IEC 14496-15); AV1 frames are hashed without temporal delimiters, which WebM omits.
/// `has_lengths`: whether `bytes` has length prefixes.
std::uint64_t packet_hash(std::string_view codec, std::span<const std::uint8_t> bytes,
                          bool has_lengths);

}  // namespace mien::render
