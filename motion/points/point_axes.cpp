#include "motion/points/point_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/math/percentile.h"
#include "motion/points/upward.h"
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
/// A body that stands along the usual axis of the format, or the stated one, is not taken to lie:
/// its zero may be that of a force plate.
std::optional<UpAxis> up_by_floor(const PointRecording& recording, const UpAxis& body,
                                  double metres_per_unit) {
  if (body.direction == usual_up(recording) || body.direction == stated_up(recording))
    return std::nullopt;
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

void add_note(PointAxes& axes, const std::string& note) {
  axes.note += (axes.note.empty() ? "" : " ") + note;
}

void note_if_misstated(const PointRecording& recording, PointAxes& axes) {
  const std::string& stated = recording.stated_up;
  if (stated.empty() || stated == axes.up || recording.positions.empty()) return;
  add_note(axes, "The file states that " + stated + " is up, but its points show that " + axes.up +
                     " is, which is used.");
}

/// Says so if nothing in the file tells which way is up.
void note_if_assumed(const PointRecording& recording, UpwardEvidence evidence, PointAxes& axes) {
  const bool is_usual = evidence == UpwardEvidence::format;
  axes.is_up_assumed = is_usual || evidence == UpwardEvidence::nothing;
  if (!axes.is_up_assumed || recording.positions.empty()) return;
  add_note(axes, "Neither the names nor the motion of the points tell which way is up: " + axes.up +
                     " is assumed" +
                     (is_usual ? std::string(", as is usual in ") +
                                     (recording.format == "c3d" ? "C3D" : "TRC") + " files."
                               : "."));
}

}  // namespace

PointAxes point_axes(const PointRecording& recording) {
  PointAxes axes;
  const Upward upward = upward_in(recording);
  const bool is_named = upward.evidence == UpwardEvidence::names;
  UpAxis up = up_axes().front();
  for (const UpAxis& axis : up_axes())
    if (axis.direction.dot(upward.direction) > up.direction.dot(upward.direction)) up = axis;
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
  axes.is_up_stated = upward.evidence == UpwardEvidence::statement;
  note_if_misstated(recording, axes);
  note_if_assumed(recording, upward.evidence, axes);
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
  if (!recording.stated_up.empty()) recording.stated_up = "+Y";
  return recording;
}

PointRecording in_metres_y_up(PointRecording recording) {
  const PointAxes axes = point_axes(recording);
  return in_metres_y_up(std::move(recording), axes);
}

}  // namespace mien::motion
