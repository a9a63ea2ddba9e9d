#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/geometry/shadow_mask.h"
#include "render/light/line_shadow.h"
#include "render/math/vector.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// The shadows of area lights on the floor of a tile: by line sampling (line_shadow.h) or, if
/// Quality::floor_sharing_pixels says so, from what was found for the floor nearby
/// (SharedOcclusion).
///
/// Samples share lines where penumbrae are wide: four samples of a pixel in penumbrae at least 4
/// pixels wide. With two samples per pixel, the samples of two pixels share a line in penumbrae at
/// least 8 pixels wide, and those of 2 × 2 pixels in those at least 16 pixels wide. The line is
/// that of one of the samples, chosen at random: whether that one shows the floor does not matter.
class FloorLines {
 public:
  explicit FloorLines(const PreparedScene& prepared)
      : prepared_(prepared), casters_(prepared.scene.lights.size()) {}

  /// Begins a tile in which the figure may occlude these lights (bit i: light i). `area` is a
  /// rectangle of the floor that contains what the tile shows; nothing if it extends to the
  /// horizon.
  void begin_tile(const Tile& tile, std::uint32_t lights, const std::optional<FloorArea>& area);

  /// Bit i: the shadows of light i on the floor are found so, without rays for each sample.
  std::uint32_t lights() const {
    return prepared_.quality.floor_sharing_pixels > 0 ? ~0u : prepared_.line_lights;
  }

  /// Width of the block of pixels that share lines.
  int block_width() const { return block_width_; }

  /// Adds the samples [first, first + count) of a pixel that show the floor; the figure may occlude
  /// these lights from them.
  void add(int x, int y, std::uint32_t lights, int first, int count);

  /// Computes the occluded light of all samples that were added.
  void resolve();

  bool is_empty() const { return is_empty_; }  ///< whether no samples were added

  /// Whether samples of the pixel were added.
  bool has(int x, int y) const { return !is_empty_ && samples_[number(x, y)] > 0; }

  /// Light that the figure occludes (irradiance divided by π), summed over the samples of the pixel
  /// that were added.
  const Color& occluded(int x, int y) const { return occluded_[number(x, y)]; }

  /// Removes the samples of a pixel.
  void remove(int x, int y) { samples_[number(x, y)] = 0; }

 private:
  /// A line for some samples of a pixel, or for all samples of a block of pixels.
  struct Query {
    int x = 0;  // of the pixel, or the first of the block
    int y = 0;
    std::uint32_t lights = 0;
    int group = 0;    // index of the group of samples that share the line
    int samples = 0;  // number of these samples; not used for a block
  };
  static constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;

  std::size_t number(int x, int y) const {
    return static_cast<std::size_t>((y - tile_.y_begin) * tile_size + x - tile_.x_begin);
  }
  bool is_of_block() const { return block_width_ > 1; }
  void share_lines(float penumbra);
  void add_blocks();
  void enqueue(const Query& query);
  void resolve_batch();
  void choose_lines();
  void add_hidden(int light);
  void put(const Query& query, const Color& occluded);

  const PreparedScene& prepared_;
  Tile tile_{};
  std::vector<std::vector<int>> casters_;  // per light: the round cones that may occlude it
  int group_size_ = 1;                     // samples that share a line
  int block_width_ = 1;                    // pixels whose samples share a line
  int block_height_ = 1;
  bool any_shared_ = false;  // some pixel is in is_shared_
  bool is_empty_ = true;     // no samples were added; the lists of pixels are then invalid
  std::array<int, pixels> samples_{};           // number of samples that were added
  std::array<std::uint32_t, pixels> lights_{};  // lights of a block, at its first pixel
  std::array<bool, pixels> is_shared_{};        // some shadows are those found nearby
  std::array<Color, pixels> occluded_;

  std::array<Query, lanes> queries_;
  int count_ = 0;
  LaneVectors points_;  // points of the floor
  LaneWords index_;     // indices of the random numbers
  LaneFloats across_;   // position on the first light, in [0, 1)
  std::array<bool, lanes> meets_floor_{};
  std::array<Color, lanes> hidden_light_;  // per sample
  std::array<std::vector<LineInterval>, lanes> hidden_;
};

}  // namespace mien::render
