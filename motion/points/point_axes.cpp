#include "motion/points/point_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/math/percentile.h"
#include "motion/points/marker_sets.h"
#include "motion/rig/unit_guess.h"

namespace mien::motion {

namespace {

constexpr double low_percent = 3.0;

struct UpAxis {
  const char* name;
  Vec3 direction;
  Quat turn;  ///< takes `direction` to +Y
};

std::array<UpAxis, 6> up_axes() {
  const double half = std::sqrt(0.5);
  return {{{"+Y", {0, 1, 0}, Quat::Identity()},
           {"+Z", {0, 0, 1}, Quat(half, -half, 0, 0)},
           {"+X", {1, 0, 0}, Quat(half, 0, 0, half)},
           {"-Y", {0, -1, 0}, Quat(0, 1, 0, 0)},
           {"-Z", {0, 0, -1}, Quat(half, half, 0, 0)},
           {"-X", {-1, 0, 0}, Quat(half, 0, 0, -half)}}};
}

double median(std::vector<double> values) { return percentile(values, 50.0); }

/// Mean position in a frame of the seen points among `points`.
std::optional<Vec3> mean_of(const PointRecording& recording, int frame,
                            const std::vector<int>& points) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const int point : points) {
    const std::size_t at = recording.at(frame, point);
    if (!recording.seen[at]) continue;
    sum += recording.positions[at];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return Vec3(sum / count);
}

std::vector<int> points_among(const MarkerSet& set, std::initializer_list<Landmark> landmarks) {
  std::vector<int> points;
  for (const Landmark landmark : landmarks) {
    for (const Side side : {Side::middle, Side::left, Side::right}) {
      const std::vector<int> found = set.points_of(landmark, side);
      points.insert(points.end(), found.begin(), found.end());
    }
  }
  return points;
}

/// Median over the frames of the vector from one group of points to another; none if there is no
/// frame with both.
std::optional<Vec3> median_vector(const PointRecording& recording, const std::vector<int>& from,
                                  const std::vector<int>& to) {
  std::array<std::vector<double>, 3> parts;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const std::optional<Vec3> low = mean_of(recording, frame, from);
    const std::optional<Vec3> high = mean_of(recording, frame, to);
    if (!low || !high) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      parts[axis].push_back((*high)[static_cast<int>(axis)] - (*low)[static_cast<int>(axis)]);
    }
  }
  if (parts[0].empty()) return std::nullopt;
  return Vec3(median(parts[0]), median(parts[1]), median(parts[2]));
}

/// From the feet to the trunk, by the names of the points.
std::optional<Vec3> upward_by_names(const PointRecording& recording) {
  using enum Landmark;
  const MarkerSet set = recognised_marker_set(recording.points);
  if (set.name.empty()) return std::nullopt;
  const std::vector<int> feet =
      points_among(set, {ankle, toe, toe_tip, outer_ankle, inner_ankle, heel, first_metatarsal,
                         second_metatarsal, fifth_metatarsal, foot});
  const std::vector<int> above =
      points_among(set, {neck, head, mid_shoulders, head_centre, head_top, shoulder, acromion,
                         cervical_7, jugular_notch, head_front, head_back, nose, ear});
  const std::vector<int> pelvis_points = points_among(
      set, {pelvis, mid_hips, hip, front_iliac_spine, back_iliac_spine, sacrum, iliac_crest});
  if (const auto upward = median_vector(recording, feet, above)) return upward;
  return median_vector(recording, feet, pelvis_points);
}

/// Lowest and highest coordinate of the seen points of a frame along a direction.
struct Extent {
  double low;
  double high;
};

std::vector<Extent> extents(const PointRecording& recording, const Vec3& direction) {
  std::vector<Extent> result;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    std::optional<Extent> extent;
    for (int point = 0; point < recording.point_count(); ++point) {
      const std::size_t at = recording.at(frame, point);
      if (!recording.seen[at]) continue;
      const double along = direction.dot(recording.positions[at]);
      if (!extent) extent = Extent{along, along};
      extent->low = std::min(extent->low, along);
      extent->high = std::max(extent->high, along);
    }
    if (extent) result.push_back(*extent);
  }
  return result;
}

/// Range of the middle 90 % of the values.
double spread(const std::vector<double>& values) {
  return percentile(values, 95.0) - percentile(values, 5.0);
}

/// Up by the shape of the cloud: the axis with the greatest extent less its travel, and on it the
/// end away from the one that keeps its level.
Vec3 upward_by_shape(const PointRecording& recording) {
  Vec3 best = Vec3::UnitY();
  double best_score = 0.0;
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
    std::vector<double> sizes;
    std::vector<double> middles;
    std::vector<double> lows;
    std::vector<double> highs;
    for (const Extent& extent : extents(recording, axis)) {
      sizes.push_back(extent.high - extent.low);
      middles.push_back(0.5 * (extent.high + extent.low));
      lows.push_back(extent.low);
      highs.push_back(extent.high);
    }
    if (sizes.empty()) continue;
    const double score = median(sizes) / (1.0 + spread(middles) / std::max(1e-9, median(sizes)));
    if (score <= best_score * 1.02) continue;
    best_score = score;
    best = spread(lows) <= spread(highs) ? axis : Vec3(-axis);
  }
  return best;
}

/// Height of the lowest and extent of the points along a direction, metres: 3rd and 75th percentile
/// over the frames; none if nothing is seen.
std::optional<Extent> usual_extent(const PointRecording& recording, const Vec3& direction,
                                   double metres_per_unit) {
  std::vector<double> lows;
  std::vector<double> sizes;
  for (const Extent& extent : extents(recording, direction)) {
    lows.push_back(extent.low * metres_per_unit);
    sizes.push_back((extent.high - extent.low) * metres_per_unit);
  }
  if (lows.empty()) return std::nullopt;
  const double low = percentile(lows, low_percent);
  return Extent{low, low + percentile(sizes, 75.0)};
}

/// Whether the lowest points keep one level, as on a floor, and not as of someone who walks by.
bool is_level(const PointRecording& recording, const Vec3& direction, double metres_per_unit) {
  constexpr double most = 0.15;  // metres
  std::vector<double> lows;
  for (const Extent& extent : extents(recording, direction)) lows.push_back(extent.low);
  return spread(lows) * metres_per_unit < most;
}

bool is_at_zero(double lowest) { return lowest > -0.02 && lowest < 0.12; }

/// The axis that is up although the body does not stand along it: +Y or +Z if the points begin at
/// its zero in all frames, as on the floor of a laboratory, and the body either lies (its extent is
/// less than half of that along `body`) or is upside down (`body` is the opposite). Keypoints with
/// y down have their zero at the camera, so that upside down counts only in files of laboratories.
std::optional<UpAxis> up_by_floor(const PointRecording& recording, const UpAxis& body,
                                  double metres_per_unit) {
  const std::optional<Extent> along = usual_extent(recording, body.direction, metres_per_unit);
  if (!along || is_at_zero(along->low)) return std::nullopt;
  const bool is_of_laboratory = recording.format == "c3d" || recording.format == "trc";
  for (const UpAxis& axis : up_axes()) {
    if (std::string_view(axis.name) != "+Y" && std::string_view(axis.name) != "+Z") continue;
    const double cosine = axis.direction.dot(body.direction);
    if (cosine > 0.5) continue;
    const std::optional<Extent> extent = usual_extent(recording, axis.direction, metres_per_unit);
    if (!extent || !is_at_zero(extent->low)) continue;
    if (!is_level(recording, axis.direction, metres_per_unit)) continue;
    const bool lies = extent->high - extent->low < 0.5 * (along->high - along->low);
    const bool is_upside_down = cosine < -0.5 && is_of_laboratory;
    if (lies || is_upside_down) return axis;
  }
  return std::nullopt;
}

/// The unit of a file that states none, from the body's height in it.
void guess_metres(double height, PointAxes& axes) {
  axes.is_unit_guessed = true;
  if (!(height > 0.0)) return;
  const UnitGuess guess = guess_unit(height, "");
  axes.metres_per_unit = guess.metres;
  if (guess.warning.empty()) return;
  for (const double metres : {1.0, 0.01, 0.001}) {
    const double tall = height * metres;
    if (tall < 0.5 || tall > 2.5) continue;
    axes.metres_per_unit = metres;
    return;
  }
  axes.note = guess.warning;
}

}  // namespace

PointAxes point_axes(const PointRecording& recording) {
  PointAxes axes;
  const std::optional<Vec3> named = upward_by_names(recording);
  const bool is_named = named && named->norm() > 0.0;
  const Vec3 upward = is_named ? *named : upward_by_shape(recording);
  UpAxis up = up_axes().front();
  for (const UpAxis& axis : up_axes())
    if (axis.direction.dot(upward) > up.direction.dot(upward)) up = axis;
  axes.metres_per_unit = recording.metres_per_unit;
  if (!(axes.metres_per_unit > 0.0)) {
    axes.metres_per_unit = 1.0;
    const std::optional<Extent> body = usual_extent(recording, up.direction, 1.0);
    guess_metres(body ? body->high - body->low : 0.0, axes);
  }
  const std::optional<UpAxis> by_floor =
      is_named ? up_by_floor(recording, up, axes.metres_per_unit) : std::nullopt;
  if (by_floor) {
    axes.note = std::string("The body lies or is upside down; ") + by_floor->name +
                " is taken as up, because the points begin at its zero, as at a floor.";
    axes.is_up_by_floor = true;
    up = *by_floor;
  }
  axes.up = up.name;
  axes.turn = up.turn;
  const std::optional<Extent> extent = usual_extent(recording, up.direction, axes.metres_per_unit);
  if (extent && !is_at_zero(extent->low)) axes.floor = extent->low;
  return axes;
}

PointRecording in_metres_y_up(PointRecording recording, const PointAxes& axes) {
  const Mat3 turn = axes.turn.toRotationMatrix().array().round().matrix();
  for (std::size_t at = 0; at < recording.positions.size(); ++at) {
    if (!recording.seen[at]) continue;
    recording.positions[at] = turn * recording.positions[at] * axes.metres_per_unit;
    recording.positions[at].y() -= axes.floor;
  }
  recording.unit = "m";
  recording.metres_per_unit = 1.0;
  return recording;
}

PointRecording in_metres_y_up(PointRecording recording) {
  const PointAxes axes = point_axes(recording);
  return in_metres_y_up(std::move(recording), axes);
}

}  // namespace mien::motion
