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

/// A reduced picture, small enough for all frames of a film to fit into memory.
using Thumbnail = std::vector<std::uint8_t>;

Thumbnail thumbnail_of(const render::Image8& picture);

/// The correspondence between the frames of two sequences.
struct FrameAlignment {
  struct Pair {
    int before = 0;
    int now = 0;
  };
  std::vector<Pair> pairs;           ///< ascending in both
  std::vector<int> missing;          ///< frames of the first sequence that the second lacks
  std::vector<int> added;            ///< frames of the second sequence that the first lacks
  std::vector<std::string> remarks;  ///< "frame 37 is missing", "frames 4 and 5 are swapped"
};

/// File names of the frames; empty for videos.
struct FrameNames {
  std::vector<std::string> before;
  std::vector<std::string> now;
};

/// Returns the alignment with the lowest cost, obtained by removing and inserting frames. The cost
/// of a removal and an insertion together is 0.9 times the typical difference between successive
/// frames plus four times that between matching frames (which may be encoded differently). Frames
/// are not paired if their indices differ by more than 240 and by more than 16 plus the difference
/// of the lengths. If as many frames are missing as added between two successive pairs, they count
/// as changed in place and are paired too, unless an added frame repeats a neighbouring one or
/// shows the picture of a missing one. Sequences whose lengths differ by so much that aligning them
/// would take more than 256 MB (an hour and a minute, for example) are not aligned: frames of the
/// same number are paired, and a remark gives both lengths.
FrameAlignment align(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                     const FrameNames& names = {});

/// How a picture is mirrored or rotated relative to another.
enum class Mirroring { none, left_right, upside_down, half_turn };

/// Returns "mirrored: left and right are swapped"; empty for none.
std::string_view name_of(Mirroring mirroring);

/// Returns the picture mirrored or rotated. Each operation is its own inverse.
render::Image8 mirrored(const render::Image8& picture, Mirroring mirroring);

/// Returns how the second sequence is mirrored. The result is none unless mirroring reduces the
/// difference between the sequences to less than a quarter. `width` and `height` are those of the
/// thumbnails, in pixels.
Mirroring mirroring_of(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                       int width, int height);

}  // namespace mien::pipeline
