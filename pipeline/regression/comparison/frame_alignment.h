#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/image/image.h"

namespace mien::pipeline {

/// Largest size of a thumbnail, in pixels.
inline constexpr int thumbnail_width = 32;
inline constexpr int thumbnail_height = 18;

/// A picture so small that those of a whole film fit into memory.
using Thumbnail = std::vector<std::uint8_t>;

Thumbnail thumbnail_of(const render::Image8& picture);

/// Which frame of one sequence is which of another.
struct FrameAlignment {
  struct Pair {
    int before = 0;
    int now = 0;
  };
  std::vector<Pair> pairs;           ///< ascending in both
  std::vector<int> missing;          ///< of the first, that the second lacks
  std::vector<int> added;            ///< of the second, that the first lacks
  std::vector<std::string> remarks;  ///< "frame 37 is missing", "frames 4 and 5 are exchanged"
};

/// Names of frames that are files; none where they are of a video.
struct FrameNames {
  std::vector<std::string> before;
  std::vector<std::string> now;
};

/// The cheapest way from one to the other by leaving frames out and putting frames in. Both
/// together cost nine tenths of the usual difference of two frames beside each other, and four
/// times that of frames which show the same (encoded otherwise, for instance). Frames are not
/// paired when they stand more than 240 apart, or 16 more than the lengths differ by if that is
/// more. Between the same two pairs, as many frames that are new as are missing were changed in
/// their places, and are pairs too, unless one repeats its neighbour or is exchanged.
FrameAlignment align(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                     const FrameNames& names = {});

/// How a whole picture is mirrored or turned relative to another.
enum class Mirroring { none, left_right, upside_down, half_turn };

/// "mirrored: left and right are exchanged"; empty for none.
std::string_view name_of(Mirroring mirroring);

/// The picture mirrored or turned. Each operation is its own inverse.
render::Image8 mirrored(const render::Image8& picture, Mirroring mirroring);

/// How the second sequence is mirrored: not at all unless mirroring brings its frames within a
/// quarter of their distance to the first. `width` and `height` are those of the thumbnails, in
/// pixels.
Mirroring mirroring_of(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                       int width, int height);

}  // namespace mien::pipeline
