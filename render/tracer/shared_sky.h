#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/light/shading.h"
#include "render/tracer/samples.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// The light of the sky that the figure occludes from its own surfaces, in one tile, averaged over
/// neighbouring samples of the same surface.
///
/// For previews: with the few rays that they have, an occluded ray would leave a dark dash. Samples
/// count as of one surface if they show the same part and their normals differ by less than 60°;
/// those with similar normals count most. They are neighbours within 3 rows and one pair of
/// columns, in one tile.
class SharedSky {
 public:
  /// Begins a tile, without samples.
  void begin_tile(const Tile& tile);

  /// Adds a sample that was shaded as if its whole sky were visible; returns its number.
  int add(const Sample& sample, const Surface& surface);

  /// Adds to the light that a sample lacks: irradiance divided by π.
  void occlude(int number, const Color& light) {
    samples_[static_cast<std::size_t>(number)].occluded += light;
  }

  /// Subtracts from the pixels what they reflect of the light that the samples lack.
  void subtract() const;

 private:
  static constexpr int rows = tile_size;
  static constexpr int columns = tile_size / 2;  // samples may represent two pixels of a row

  struct SkySample {
    Sample sample;
    Vec3 normal;
    Color albedo;
    Color occluded;
    int part;
    int row;
    int column;
    int next;  // sample of the same row and column; −1: none
  };

  Color mean_near(const SkySample& here) const;

  int x_begin_ = 0;
  int y_begin_ = 0;
  std::vector<SkySample> samples_;
  std::array<int, static_cast<std::size_t>(rows* columns)> first_;
};

}  // namespace mien::render
