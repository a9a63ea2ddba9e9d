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

  /// Adds a sample that was shaded as if its whole sky were visible; returns its number. Samples
  /// are added row by row, from left to right.
  int add(const Sample& sample, const Surface& surface);

  /// Adds to the light that a sample lacks: irradiance divided by π.
  void occlude(int number, const Color& light) {
    const auto i = static_cast<std::size_t>(number);
    lists_.red[i] += light[0];
    lists_.green[i] += light[1];
    lists_.blue[i] += light[2];
  }

  /// Subtracts from the pixels what they reflect of the light that the samples lack.
  void subtract();

 private:
  static constexpr int rows = tile_size;
  static constexpr int columns = tile_size / 2;  // samples may represent two pixels of a row

  /// Values of the samples, a list per quantity. `subtract` appends eight samples of weight 0, so
  /// that eight values can be read from any sample on.
  struct Lists {
    std::vector<float> normal_x, normal_y, normal_z;
    std::vector<float> red, green, blue;  // occluded light
    std::vector<float> weight;            // number of camera rays that each represents
    std::vector<int> part;
  };
  struct SkySample {
    Sample sample;
    Color albedo;
    int row;
    int column;
  };
  struct Sums {
    LaneFloats red, green, blue, weight;
  };

  void append(const Vec3& normal, float weight, int part);
  static void add_near(const Lists& lists, int here, int begin, int end, Sums& sums);
  Color mean_near(int number) const;

  int x_begin_ = 0;
  int y_begin_ = 0;
  std::vector<SkySample> samples_;
  Lists lists_;
  // Per row and column of the tile: the number of the first sample there or after.
  std::array<int, static_cast<std::size_t>(rows* columns) + 1> first_;
};

}  // namespace mien::render
