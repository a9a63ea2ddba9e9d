#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/animate/displacement_curve.h"
#include "motion/animate/pose_change.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The parts of a PoseChange that keys move.
enum class ChangePart {
  pelvis,
  left_foot,
  right_foot,
  trunk,
  left_hand,  ///< PoseChange::swings
  right_hand,
  gaze,
  left_stretch,  ///< PoseChange::stretches, as the first of three numbers
  right_stretch,
};

inline constexpr int change_part_count = 9;

/// The stretch that belongs to a hand; nothing for other parts.
std::optional<ChangePart> stretch_of(ChangePart part);

/// Changes of a motion's poses over time, as displacement curves through keys.
class ChangeCurves {
 public:
  explicit ChangeCurves(const Clip& clip);

  const std::vector<CurveKey>& keys(ChangePart part) const { return part_of(part).keys; }
  void set_keys(ChangePart part, std::vector<CurveKey> keys);
  /// Adds a key, or changes the one at the same moment.
  void put_key(ChangePart part, const CurveKey& key);
  void set_value(ChangePart part, std::size_t key, const Vec3& value);

  Vec3 at(ChangePart part, double seconds) const { return part_of(part).curve.at(seconds); }
  PoseChange at(double seconds) const;

 private:
  struct Part {
    std::vector<CurveKey> keys;
    DisplacementCurve curve;
  };

  const Part& part_of(ChangePart part) const { return parts_[static_cast<std::size_t>(part)]; }

  std::optional<double> period_;
  std::array<Part, change_part_count> parts_;
};

/// A key whose value was shortened.
struct StoppedKey {
  double seconds = 0.0;
  double share = 1.0;  ///< that remained of its value
  std::string reason;  ///< "the range of the left elbow's flexion"
};

/// Shortens the values of a part's keys with which a joint would leave its range (joint_angles.h)
/// farther than without the key, or a leg would be too short for its foot, to the longest with
/// which that is not so in any frame of their reach.
std::vector<StoppedKey> stop_at_joint_limits(const Clip& clip, ChangeCurves& curves,
                                             ChangePart part);

}  // namespace mien::motion
