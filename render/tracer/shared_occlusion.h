#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/light/shading.h"
#include "render/tracer/samples.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// Light that samples of one tile lack, averaged over neighbouring samples of the same surface: the
/// light of the sky that the figure occludes from its own surfaces, and that of the area lights
/// that it occludes from the floor.
///
/// For previews: with the few rays that they have, an occluded ray would leave a dark dash. Samples
/// count as of one surface if they show the same part and their normals differ by less than 60°;
/// those with similar normals count most. They are neighbours within one pair of columns, and
/// within 3 rows on the figure and 2 rows on the floor, in one tile.
class SharedOcclusion {
 public:
  /// Begins a tile, without samples.
  void begin_tile(const Tile& tile);

  /// Adds a sample that was shaded as if nothing were occluded; returns its number.
  int add_figure(const Sample& sample, const Surface& surface);
  /// As above, for a sample of the floor; pixels have its albedo (Pixel::floor_albedo).
  int add_floor(const Sample& sample);

  /// Adds to the light that a sample lacks: irradiance divided by π.
  void occlude(int number, const Color& light) {
    samples_[static_cast<std::size_t>(number)].occluded += light;
  }

  /// Subtracts from the pixels what they reflect of the light that the samples lack.
  void subtract();

 private:
  static constexpr int rows = tile_size;
  static constexpr int columns = tile_size / 2;  // samples may represent two pixels of a row

  struct SharedSample {
    Sample sample;
    Vec3 normal;
    Color albedo;  // of the figure
    int part;
    Color occluded = Color::Zero();
  };
  /// Values of the samples by row and column, a list per quantity. Eight samples of weight 0
  /// follow, so that eight values can be read from any sample on.
  struct Lists {
    std::vector<float> normal_x, normal_y, normal_z;
    std::vector<float> red, green, blue;  // occluded light
    std::vector<float> weight;            // number of camera rays that each represents
    std::vector<int> part;
  };
  struct Sums {
    LaneFloats red, green, blue, weight;
  };

  int row_of(const SharedSample& sample) const { return sample.sample.pixel->y - y_begin_; }
  int column_of(const SharedSample& sample) const {
    return (sample.sample.pixel->x - x_begin_) / 2;
  }
  void make_lists();
  static void add_near(const Lists& lists, int here, int begin, int end, Sums& sums);
  Color mean_near(const SharedSample& sample, int place) const;

  int x_begin_ = 0;
  int y_begin_ = 0;
  std::vector<SharedSample> samples_;
  std::vector<int> places_;  // of the samples in the lists
  Lists lists_;
  // Per row and column of the tile: the place of the first sample there or after.
  std::array<int, static_cast<std::size_t>(rows* columns) + 1> first_;
};

}  // namespace mien::render
