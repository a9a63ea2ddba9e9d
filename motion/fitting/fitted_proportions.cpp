#include "motion/fitting/fitted_proportions.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// Median place of a track in a frame that is given by its origin, left and up.
std::optional<Vec3> median_place(const Track& track, const Track& origin, const Track& left,
                                 const Track& up) {
  return median_of(
      combined([](const Vec3& p, const Vec3& o, const Vec3& x,
                  const Vec3& y) { return Vec3(frame_from(x, y).conjugate() * (p - o)); },
               track, origin, left, up));
}

/// As `median_place`, with `up` exact and `left` approximate, as the frame of the chest is.
std::optional<Vec3> median_place_along(const Track& track, const Track& origin, const Track& left,
                                       const Track& up) {
  const Track square = combined(
      [](const Vec3& x, const Vec3& y) { return Vec3((x - y * y.dot(x)).normalized()); }, left, up);
  return median_place(track, origin, square, up);
}

class Proportions {
 public:
  explicit Proportions(const BodyTracks& tracks)
      : tracks_(tracks), body_(standard_body(1.75 * tracks.scale)) {}

  Skeleton body() {
    set_trunk();
    set_limbs();
    set_feet();
    set_tips();
    return std::move(body_);
  }

 private:
  Vec3& offset(BodyJoint joint) { return body_.joints[joint].offset; }
  const Track& at(BodyJoint joint) const { return tracks_.joints[joint]; }

  /// Makes the bone from the joint's parent as long as measured, on both sides of the body if only
  /// one is known.
  void set_length(BodyJoint joint) {
    const auto measured = [&](BodyJoint end) {
      return median_distance(at(BodyJoint(body_parents[end])), at(end));
    };
    std::optional<double> length = measured(joint);
    if (!length) length = measured(mirrored(joint));
    if (length && *length > 1e-3) offset(joint) = offset(joint).normalized() * *length;
  }

  void set_hips() {
    for (const BodyJoint hip : {LeftHip, RightHip}) {
      const auto place = median_place(at(hip), at(Pelvis), tracks_.pelvis_left, tracks_.pelvis_up);
      if (place) offset(hip) = *place;
    }
  }

  void set_trunk() {
    set_hips();
    for (const BodyJoint joint : {Spine, Chest, Neck, Head}) set_length(joint);
    for (const bool left : {true, false}) set_shoulder(left);
  }

  void set_shoulder(bool left) {
    const BodyJoint clavicle = left ? LeftClavicle : RightClavicle;
    const BodyJoint shoulder = left ? LeftShoulder : RightShoulder;
    const auto place = [&](BodyJoint joint) {
      return median_place_along(at(joint), at(Chest), tracks_.chest_left, tracks_.chest_up);
    };
    const std::optional<Vec3> inner = place(clavicle);
    std::optional<Vec3> outer = place(shoulder);
    if (!outer) {
      outer = place(mirrored(shoulder));
      if (outer) outer->x() = -outer->x();
    }
    if (inner) offset(clavicle) = *inner;
    if (!outer) return;
    if (!inner) offset(clavicle).y() = outer->y();
    const double length = (*outer - offset(clavicle)).norm();
    if (length > 1e-3) offset(shoulder) = Vec3(left ? length : -length, 0.0, 0.0);
  }

  void set_limbs() {
    for (const BodyJoint joint : {LeftElbow, RightElbow, LeftWrist, RightWrist, LeftKnee, RightKnee,
                                  LeftAnkle, RightAnkle}) {
      set_length(joint);
    }
  }

  /// How far the toe joint is below the ankle in the frames in which the toes are down: a low
  /// percentile, since the heel rises before the toes do.
  std::optional<double> ankle_height(BodyJoint ankle, BodyJoint toe) const {
    std::vector<double> levels;
    for (const auto& point : at(toe)) {
      if (point) levels.push_back(point->y());
    }
    if (levels.empty()) return std::nullopt;
    const double down = percentile(levels, 10.0) + 0.015;
    std::vector<double> heights;
    for (std::size_t frame = 0; frame < at(toe).size(); ++frame) {
      if (!at(toe)[frame] || !at(ankle)[frame] || at(toe)[frame]->y() > down) continue;
      heights.push_back(at(ankle)[frame]->y() - at(toe)[frame]->y());
    }
    if (heights.empty()) return std::nullopt;
    return percentile(heights, 20.0);
  }

  void set_feet() {
    for (const bool left : {true, false}) {
      const BodyJoint toe = left ? LeftToe : RightToe;
      set_length(toe);
      const double length = offset(toe).norm();
      std::optional<double> height = ankle_height(BodyJoint(body_parents[toe]), toe);
      if (!height) {
        const BodyJoint other = mirrored(toe);
        height = ankle_height(BodyJoint(body_parents[other]), other);
      }
      if (!height) continue;
      const double down = std::clamp(*height, 0.1 * length, 0.8 * length);
      offset(toe) = Vec3(0.0, -down, std::sqrt(length * length - down * down));
    }
  }

  void set_tips() {
    for (const BodyJoint joint : {Head, LeftWrist, RightWrist, LeftToe, RightToe}) {
      std::optional<double> length = median_distance(at(joint), tracks_.tips[joint]);
      const BodyJoint other = mirrored(joint);
      if (!length) length = median_distance(at(other), tracks_.tips[other]);
      Vec3& tip = *body_.joints[joint].tip;
      if (length && *length > 1e-3) tip = tip.normalized() * *length;
    }
  }

  const BodyTracks& tracks_;
  Skeleton body_;
};

}  // namespace

Skeleton fitted_proportions(const BodyTracks& tracks) { return Proportions(tracks).body(); }

}  // namespace mien::motion
