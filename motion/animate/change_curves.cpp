#include "motion/animate/change_curves.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/animate/body_end.h"
#include "motion/animate/joint_excess.h"

namespace mien::motion {

namespace {

constexpr double tolerance = excess_tolerance_deg;  // also millimetres of a leg that is too short
constexpr int key_halvings = 14;

/// Whether the angle depends on the part.
bool concerns(ChangePart part, const JointAngle& angle) {
  const auto one_of = [&](std::initializer_list<BodyJoint> joints) {
    return std::find(joints.begin(), joints.end(), angle.joint) != joints.end();
  };
  switch (part) {
    case ChangePart::pelvis:
      return one_of({LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle});
    case ChangePart::left_foot:
      return one_of({LeftHip, LeftKnee, LeftAnkle});
    case ChangePart::right_foot:
      return one_of({RightHip, RightKnee, RightAnkle});
    case ChangePart::trunk:
      return angle.joint == Chest;
    case ChangePart::left_hand:
      return one_of({LeftShoulder, LeftElbow});
    case ChangePart::right_hand:
      return one_of({RightShoulder, RightElbow});
    case ChangePart::gaze:
      return angle.joint == Head;
    default:
      break;
  }
  return false;
}

bool moves_legs(ChangePart part) {
  return part == ChangePart::pelvis || part == ChangePart::left_foot ||
         part == ChangePart::right_foot;
}

/// Of the angles that depend on the part; 0 for the others.
std::vector<double> excesses(const Pose& pose, ChangePart part) {
  std::vector<double> values = joint_excesses(pose);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!concerns(part, joint_angles()[i])) values[i] = 0.0;
  return values;
}

/// By how much the left and the right leg are too short for their feet, millimetres.
std::array<double, 2> leg_shortages(const Skeleton& body, const Pose& before, const Pose& after,
                                    const PoseChange& change) {
  const JointTransforms from = world_transforms(body, before);
  const JointTransforms to = world_transforms(body, after);
  const auto shortage = [&](BodyEnd foot, const Vec3& shift) {
    return 1000.0 * (place_of(body, from, foot) + shift - place_of(body, to, foot)).norm();
  };
  return {shortage(BodyEnd::left_foot, change.feet[0]),
          shortage(BodyEnd::right_foot, change.feet[1])};
}

class KeyStop {
 public:
  KeyStop(const Clip& clip, ChangeCurves& curves, ChangePart part, std::size_t key)
      : clip_(clip), curves_(curves), part_(part), key_(key) {
    const CurveKey known = curves.keys(part)[key];
    wanted_ = known.value;
    if (const auto stretch = stretch_of(part)) wanted_stretch_ = curves.keys(*stretch)[key].value;
    const double rate = clip.frames_per_second;
    times_ = {known.from, known.to};
    const int first = static_cast<int>(std::ceil((known.from - known.before) * rate));
    const int last = static_cast<int>(std::floor((known.to + known.after) * rate));
    for (int f = first; f <= last; ++f) {
      if (clip.loops || (f >= 0 && f < clip.frame_count())) times_.push_back(f / rate);
    }
    set(0.0);
    for (const double time : times_) {
      without_.push_back(measured(time));
      // A foot has to reach its own place, not the one that it had without the key.
      if (part == ChangePart::left_foot) without_.back().end()[-2] = 0.0;
      if (part == ChangePart::right_foot) without_.back().end()[-1] = 0.0;
    }
  }

  StoppedKey stop() {
    StoppedKey result{curves_.keys(part_)[key_].from, 1.0, ""};
    result.reason = hindrance(1.0);
    if (result.reason.empty()) return result;
    double free = 0.0, stopped = 1.0;
    for (int i = 0; i < key_halvings; ++i) {
      const double tried = 0.5 * (free + stopped);
      const std::string reason = hindrance(tried);
      if (!reason.empty()) result.reason = reason;
      (reason.empty() ? free : stopped) = tried;
    }
    set(free);
    result.share = free;
    return result;
  }

 private:
  void set(double share) {
    curves_.set_value(part_, key_, share * wanted_);
    if (const auto stretch = stretch_of(part_))
      curves_.set_value(*stretch, key_, share * wanted_stretch_);
  }

  /// The angles' excesses and the legs' shortages at a time.
  std::vector<double> measured(double time) const {
    const Pose before = pose_at(clip_, time);
    const PoseChange change = curves_.at(time);
    const Pose after = changed(clip_.body, before, change);
    std::vector<double> values = excesses(after, part_);
    if (moves_legs(part_)) {
      const auto shortages = leg_shortages(clip_.body, before, after, change);
      values.insert(values.end(), shortages.begin(), shortages.end());
    }
    return values;
  }

  static std::string in_words(std::size_t measure) {
    const std::size_t angles = joint_angles().size();
    if (measure < angles) return range_in_words(joint_angles()[measure]);
    return measure == angles ? "the length of the left leg" : "the length of the right leg";
  }

  /// What stops the key at a share of its value; empty if nothing does.
  std::string hindrance(double share) {
    set(share);
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const std::vector<double> now = measured(times_[i]);
      for (std::size_t a = 0; a < now.size(); ++a) {
        if (now[a] > without_[i][a] + tolerance) return in_words(a);
      }
    }
    return "";
  }

  const Clip& clip_;
  ChangeCurves& curves_;
  ChangePart part_;
  std::size_t key_;
  Vec3 wanted_;
  Vec3 wanted_stretch_ = Vec3::Zero();
  std::vector<double> times_;
  std::vector<std::vector<double>> without_;
};

}  // namespace

std::optional<ChangePart> stretch_of(ChangePart part) {
  if (part == ChangePart::left_hand) return ChangePart::left_stretch;
  if (part == ChangePart::right_hand) return ChangePart::right_stretch;
  return std::nullopt;
}

ChangeCurves::ChangeCurves(const Clip& clip) {
  if (clip.loops) period_ = clip.duration_seconds();
}

void ChangeCurves::set_keys(ChangePart part, std::vector<CurveKey> keys) {
  Part& own = parts_[static_cast<std::size_t>(part)];
  own.keys = std::move(keys);
  own.curve = DisplacementCurve(own.keys, period_);
}

void ChangeCurves::put_key(ChangePart part, const CurveKey& key) {
  std::vector<CurveKey> keys = this->keys(part);
  const auto known = std::find_if(keys.begin(), keys.end(),
                                  [&](const CurveKey& one) { return one.from == key.from; });
  if (known == keys.end()) {
    keys.push_back(key);
  } else {
    *known = key;
  }
  set_keys(part, std::move(keys));
}

void ChangeCurves::set_value(ChangePart part, std::size_t key, const Vec3& value) {
  std::vector<CurveKey> keys = this->keys(part);
  keys[key].value = value;
  set_keys(part, std::move(keys));
}

PoseChange ChangeCurves::at(double seconds) const {
  PoseChange change;
  change.pelvis = at(ChangePart::pelvis, seconds);
  change.trunk = at(ChangePart::trunk, seconds);
  change.gaze = at(ChangePart::gaze, seconds);
  change.swings = {at(ChangePart::left_hand, seconds), at(ChangePart::right_hand, seconds)};
  change.stretches = {at(ChangePart::left_stretch, seconds).x(),
                      at(ChangePart::right_stretch, seconds).x()};
  change.feet = {at(ChangePart::left_foot, seconds), at(ChangePart::right_foot, seconds)};
  return change;
}

std::vector<StoppedKey> stop_at_joint_limits(const Clip& clip, ChangeCurves& curves,
                                             ChangePart part) {
  std::vector<StoppedKey> stopped;
  for (std::size_t key = 0; key < curves.keys(part).size(); ++key) {
    if (curves.keys(part)[key].value.isZero(0.0)) continue;
    StoppedKey result = KeyStop(clip, curves, part, key).stop();
    if (result.share < 1.0) stopped.push_back(std::move(result));
  }
  return stopped;
}

}  // namespace mien::motion
