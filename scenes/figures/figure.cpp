#include "scenes/figures/figure.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "motion/skeleton/body.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::scenes {

namespace {

constexpr double least_height_m = 0.2;

/// The median over the frames of the vertical extent of the markers.
double height_of(const motion::Markers& markers) {
  std::vector<double> heights;
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (int point = 0; point < markers.point_count(); ++point) {
      const std::size_t at = markers.at(frame, point);
      if (!markers.is_known(at)) continue;
      least = std::min(least, markers.positions[at].y());
      most = std::max(most, markers.positions[at].y());
    }
    if (least <= most) heights.push_back(most - least);
  }
  if (heights.empty()) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::ranges::nth_element(heights, middle);
  return *middle;
}

}  // namespace

double figure_height(const motion::Clip& clip) {
  if (motion::is_body(clip.body)) return motion::standing_height(clip.body);
  if (const motion::Markers* markers = motion::markers_of(clip))
    return std::max(height_of(*markers), least_height_m);
  const motion::JointTransforms world = motion::world_transforms(clip.body, clip.poses.front());
  double height = 0.0;
  const auto reach = [&](const motion::Vec3& point) {
    height = std::max(height, (point - world.positions.front()).norm());
  };
  for (size_t j = 0; j < world.positions.size(); ++j) {
    reach(world.positions[j]);
    const auto& tip = clip.body.joints[j].tip;
    if (tip) reach(world.positions[j] + world.rotations[j] * *tip);
  }
  return std::max(height, least_height_m);
}

const FigureKind& kind_of(const Figure& figure) {
  return std::visit([](const auto& options) -> const FigureKind& { return options.kind; }, figure);
}

const PointLightOptions* dots_in(const Figure& figure) {
  if (const auto* markers = std::get_if<MarkersOptions>(&figure)) return &markers->dots;
  return std::get_if<PointLightOptions>(&figure);
}

PointLightOptions* dots_in(Figure& figure) {
  return const_cast<PointLightOptions*>(dots_in(std::as_const(figure)));
}

Figure with_face(Figure figure, const Face& face) {
  const auto put = [&]<class Options>(Options& options) {
    if constexpr (std::is_same_v<Options, CharacterOptions>) options.face = face;
  };
  auto* trail = std::get_if<TrailOptions>(&figure);
  if (trail != nullptr) {
    std::visit(put, trail->figure);
  } else {
    std::visit(put, figure);
  }
  return figure;
}

const std::filesystem::path* file_of(const Figure& figure) {
  const auto file = []<class Options>(const Options& options) -> const std::filesystem::path* {
    if constexpr (FromFile<Options>) return &options.file;
    return nullptr;
  };
  const auto* trail = std::get_if<TrailOptions>(&figure);
  return trail != nullptr ? std::visit(file, trail->figure) : std::visit(file, figure);
}

}  // namespace mien::scenes
