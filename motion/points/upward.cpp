#include "motion/points/upward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "motion/math/percentile.h"
#include "motion/points/marker_sets.h"

namespace mien::motion {

namespace {

/// Parts of the body from below to above, as far as points tell them.
enum class Part { foot, shank, knee, pelvis, trunk, head, other };

Part part_of(Landmark landmark) {
  using enum Landmark;
  switch (landmark) {
    case ankle:
    case toe:
    case toe_tip:
    case outer_ankle:
    case inner_ankle:
    case heel:
    case first_metatarsal:
    case second_metatarsal:
    case fifth_metatarsal:
    case foot:
      return Part::foot;
    case knee:
    case outer_knee:
    case inner_knee:
      return Part::knee;
    case shank:
      return Part::shank;
    case pelvis:
    case mid_hips:
    case hip:
    case front_iliac_spine:
    case back_iliac_spine:
    case sacrum:
    case iliac_crest:
      return Part::pelvis;
    case neck:
    case mid_shoulders:
    case shoulder:
    case acromion:
    case cervical_7:
    case jugular_notch:
      return Part::trunk;
    case head:
    case head_centre:
    case head_top:
    case head_front:
    case head_back:
    case nose:
    case ear:
      return Part::head;
    default:
      return Part::other;
  }
}

struct PartWord {
  std::string_view word;
  Part part;
};

/// Words in names of points; the first that a name holds counts ("metatarsal head", "fibula head").
constexpr PartWord part_words[] = {
    {"wheel", Part::other},   {"hand", Part::other},     {"finger", Part::other},
    {"forearm", Part::other}, {"humer", Part::other},    {"radi", Part::other},
    {"ulna", Part::other},    {"shank", Part::shank},    {"shin", Part::shank},
    {"tibia", Part::shank},   {"fibula", Part::shank},   {"toe", Part::foot},
    {"heel", Part::foot},     {"calc", Part::foot},      {"metatars", Part::foot},
    {"malleol", Part::foot},  {"ank", Part::foot},       {"foot", Part::foot},
    {"kne", Part::knee},      {"thigh", Part::other},    {"femur", Part::other},
    {"asis", Part::pelvis},   {"psis", Part::pelvis},    {"iliac", Part::pelvis},
    {"sacr", Part::pelvis},   {"pelvi", Part::pelvis},   {"hip", Part::pelvis},
    {"acrom", Part::trunk},   {"shoulder", Part::trunk}, {"clav", Part::trunk},
    {"stern", Part::trunk},   {"neck", Part::trunk},     {"head", Part::head},
    {"nose", Part::head}};

Part part_by_word(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') plain += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') plain += c;
  }
  for (const PartWord& known : part_words)
    if (plain.find(known.word) != std::string::npos) return known.part;
  return Part::other;
}

std::vector<Part> parts_of_points(const PointRecording& recording) {
  const MarkerSet set = recognised_marker_set(recording.points);
  std::vector<Part> parts;
  for (std::size_t point = 0; point < recording.points.size(); ++point) {
    const std::string& name = recording.points[point];
    const std::size_t colon = name.rfind(':');  // after a subject's name
    parts.push_back(set.roles[point] ? part_of(set.roles[point]->landmark)
                                     : part_by_word(std::string_view(name).substr(colon + 1)));
  }
  return parts;
}

double median(const std::vector<double>& values) { return percentile(values, 50.0); }

/// Mean position in a frame of the seen points of some parts.
std::optional<Vec3> mean_of(const PointRecording& recording, int frame,
                            const std::vector<Part>& parts, std::initializer_list<Part> wanted) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (int point = 0; point < recording.point_count(); ++point) {
    const std::size_t at = recording.at(frame, point);
    const Part part = parts[static_cast<std::size_t>(point)];
    if (!recording.seen[at] || std::find(wanted.begin(), wanted.end(), part) == wanted.end())
      continue;
    sum += recording.positions[at];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return Vec3(sum / count);
}

/// Median over the frames of the vector from some parts to others; none if there is no frame with
/// both.
std::optional<Vec3> median_vector(const PointRecording& recording, const std::vector<Part>& parts,
                                  std::initializer_list<Part> from,
                                  std::initializer_list<Part> to) {
  std::array<std::vector<double>, 3> along;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const std::optional<Vec3> low = mean_of(recording, frame, parts, from);
    const std::optional<Vec3> high = mean_of(recording, frame, parts, to);
    if (!low || !high) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along[axis].push_back((*high)[static_cast<int>(axis)] - (*low)[static_cast<int>(axis)]);
    }
  }
  if (along[0].empty()) return std::nullopt;
  const Vec3 vector(median(along[0]), median(along[1]), median(along[2]));
  if (!(vector.norm() > 0.0)) return std::nullopt;
  return vector;
}

bool is_along_an_axis(const Vec3& vector) {
  return vector.cwiseAbs().maxCoeff() > 0.8 * vector.norm();
}

std::optional<Vec3> upward_by_names(const PointRecording& recording) {
  const std::vector<Part> parts = parts_of_points(recording);
  const auto vector = [&](std::initializer_list<Part> from, std::initializer_list<Part> to) {
    return median_vector(recording, parts, from, to);
  };
  if (const auto upward = vector({Part::foot}, {Part::trunk, Part::head})) return upward;
  if (const auto upward = vector({Part::foot}, {Part::pelvis})) return upward;
  for (const auto& upward : {vector({Part::pelvis}, {Part::trunk, Part::head}),
                             vector({Part::knee, Part::shank}, {Part::trunk, Part::head}),
                             vector({Part::knee, Part::shank}, {Part::pelvis})})
    if (upward && is_along_an_axis(*upward)) return upward;
  return std::nullopt;
}

/// The cloud of points along one axis.
struct CloudAlong {
  double size = 0.0;   ///< median over the frames
  double score = 0.0;  ///< size, less the more it travels
  double low_spread = 0.0;
  double high_spread = 0.0;
};

CloudAlong cloud_along(const PointRecording& recording, const Vec3& axis) {
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
  if (sizes.empty()) return {};
  const double size = median(sizes);
  return {size, size / (1.0 + spread(middles) / std::max(1e-9, size)), spread(lows), spread(highs)};
}

/// Whether a cloud of points has a person's height, where the file states its unit.
bool has_height_of_person(const PointRecording& recording, double size) {
  const double metres = size * recording.metres_per_unit;
  return !(recording.metres_per_unit > 0.0) || (metres > 0.8 && metres < 2.5);
}

Upward upward_by_shape(const PointRecording& recording) {
  constexpr int fewest_points = 8;
  Upward upward;
  CloudAlong best;
  double second = 0.0;
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
    const CloudAlong cloud = cloud_along(recording, axis);
    if (cloud.score <= best.score * 1.02) {
      second = std::max(second, cloud.score);
      continue;
    }
    second = std::max(second, best.score);
    best = cloud;
    upward.direction = cloud.low_spread <= cloud.high_spread ? axis : Vec3(-axis);
  }
  const double steadier = std::min(best.low_spread, best.high_spread);
  const double looser = std::max(best.low_spread, best.high_spread);
  const bool is_clear = recording.point_count() >= fewest_points && best.score > 1.5 * second &&
                        has_height_of_person(recording, best.size) && looser > 0.015 * best.size &&
                        steadier < 0.5 * looser;
  upward.evidence = is_clear ? UpwardEvidence::shape : UpwardEvidence::nothing;
  return upward;
}

}  // namespace

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

double spread(const std::vector<double>& values) {
  return percentile(values, 95.0) - percentile(values, 5.0);
}

Vec3 stated_up(const PointRecording& recording) {
  const std::string& axis = recording.stated_up;
  if (axis.size() != 2 || axis[1] < 'X' || axis[1] > 'Z') return Vec3::Zero();
  return (axis[0] == '-' ? -1.0 : 1.0) * Vec3::Unit(axis[1] - 'X');
}

Vec3 usual_up(const PointRecording& recording) {
  if (recording.format == "trc") return Vec3::UnitY();
  if (recording.format == "c3d") return Vec3::UnitZ();
  return Vec3::Zero();
}

Upward upward_in(const PointRecording& recording) {
  if (const auto named = upward_by_names(recording)) return {*named, UpwardEvidence::names};
  const Upward by_shape = upward_by_shape(recording);
  if (by_shape.evidence == UpwardEvidence::shape) return by_shape;
  const Vec3 stated = stated_up(recording);
  if (stated.norm() > 0.0) return {stated, UpwardEvidence::statement};
  const Vec3 usual = usual_up(recording);
  if (usual.norm() > 0.0) return {usual, UpwardEvidence::format};
  return by_shape;
}

}  // namespace mien::motion
