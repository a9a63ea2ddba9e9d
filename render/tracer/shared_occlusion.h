#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "render/math/lanes.h"
#include "render/math/vector.h"

namespace mien::render {

/// Light that the figure occludes from its own surfaces and from the floor, found by rays of few
/// samples before the picture is rendered (occlusion_rays.h). Pixels take it from what was found
/// for the same surface nearby: with so few rays of its own, each would be a dark dot or none.
///
/// What is nearby are pixels whose rows and columns differ by no more than the reach or, if none of
/// them has the surface, by no more than twice the reach. On figures, they count as of the same
/// surface if they show the same part and their normals differ by less than 60°; those with similar
/// normals count most.
class SharedOcclusion {
 public:
  /// The part (index into Scene::parts) of the floor.
  static constexpr int floor_part = -1;

  /// What rays of one sample found.
  struct Found {
    int x;                           ///< the sample's pixel in its row
    int part;                        ///< index into Scene::parts, or floor_part
    Vec3 normal;                     ///< unit; of no account on the floor
    Color occluded = Color::Zero();  ///< irradiance, divided by π
    Color light = Color::Zero();     ///< what it is without occlusion; of no account on the floor
  };

  SharedOcclusion() = default;  ///< nothing is shared

  /// For a picture of so many rows; samples are shared within `figure_reach` and `floor_reach`
  /// pixels.
  SharedOcclusion(int height, int figure_reach, int floor_reach)
      : figure_reach_(figure_reach),
        floor_reach_(floor_reach),
        figure_rows_(static_cast<std::size_t>(height)),
        floor_rows_(figure_rows_.size()) {}

  /// Set what was found in a row, pixel by pixel from the left. Several threads may set different
  /// rows.
  void set_figure_row(int number, std::span<const Found> found);
  void set_floor_row(int number, std::span<const Found> found);

  /// Returns the light that is occluded in a pixel from the floor, irradiance divided by π; black
  /// if no floor was found nearby.
  Color on_floor(int x, int y) const;

  /// Returns the share of the light that is occluded in a pixel from surfaces of a part with about
  /// this normal (need not be of length 1). If the part was found nearby with other normals only,
  /// these count; black if it was not found.
  Color on_figure(int x, int y, int part, const Vec3& normal) const;

 private:
  /// What was found on figures: a list per quantity, of entries from left to right: sums over what
  /// was found for one part in a pixel, of shares that are occluded times `light`, which is the
  /// mean of red, green and blue without occlusion. Eight more values follow each list, so that
  /// eight can be read from any entry on.
  struct FigureSamples {
    enum List { normal_x, normal_y, normal_z, red, green, blue, light, lists };

    std::vector<float> values;  // list after list
    std::vector<int> parts;
    std::vector<int> first;  // per column from `begin` on, and at its end: the first entry there
    int begin = 0;

    const float* at(List list, int entry) const {
      return &values[list * parts.size() + static_cast<std::size_t>(entry)];
    }
  };
  /// What was found on the floor, column by column from `begin` on: sums over the samples of a
  /// pixel, of red, green and blue, and their number.
  struct FloorSamples {
    int begin = 0;
    std::vector<Eigen::Array4f> columns;
  };
  /// What neighbours must show. Their weights are squares of twice the cosine to this normal plus
  /// the offset, if that is positive.
  struct Look {
    int part;
    Vec3 normal;
    float offset;
  };
  /// Weighted sums over neighbours.
  struct Sums {
    LaneFloats red, green, blue, light;
  };

  static void add(const FigureSamples& row, int begin, int end, const Look& look, Sums& sums);
  std::optional<Color> floor_mean(int x, int y, int reach) const;
  std::optional<Color> figure_mean(int x, int y, int reach, const Look& look) const;

  int figure_reach_ = 0;  // pixels
  int floor_reach_ = 0;
  std::vector<FigureSamples> figure_rows_;
  std::vector<FloorSamples> floor_rows_;
};

}  // namespace mien::render
