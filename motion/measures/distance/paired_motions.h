#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A joint that two skeletons have, by its name.
struct SharedJoint {
  std::string name;
  int before = -1;    ///< index in the first skeleton
  int now = -1;       ///< index in the second
  int parent = -1;    ///< nearest joint above that is shared, as index among the shared; −1 none
  int opposite = -1;  ///< the joint of the other side; itself on the midline, −1 if missing
};

/// A motion at evenly spaced moments, with where its joints are.
struct SampledMotion {
  std::vector<Pose> poses;
  std::vector<JointTransforms> world;

  int frame_count() const { return static_cast<int>(poses.size()); }
};

/// Two motions sampled at the same times, with corresponding joints. Frame i is at i /
/// frames_per_second seconds after the start of each; neither is aligned or scaled.
struct PairedMotions {
  std::vector<SharedJoint> joints;  ///< in the order of the first skeleton; never empty
  std::vector<std::string> only_before, only_now;
  double frames_per_second = 30.0;  ///< of the first motion
  SampledMotion before;             ///< its frames as they are
  SampledMotion now;                ///< at the first's frame rate, interpolated where it differs
  int frames = 0;                   ///< number of frames that both have

  double seconds(int frame) const { return frame / frames_per_second; }
};

/// Pairs the joints by their names (of two of one name the first) and the frames by time.
/// Throws Error naming the clip when it has no frames or a number that is none, or when the two
/// have no joint in common.
PairedMotions paired(const Clip& before, const Clip& now);

/// Whether both frame rates are equal within the rounding of files.
bool same_rate(double before, double now);

/// A joint's frame relative to that of the shared joint above it; of a joint without one in the
/// world. Poses' own numbers where skeletons agree, so that equal poses give equal numbers.
struct LocalFrame {
  Vec3 offset;
  Quat rotation;
};
LocalFrame local_before(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame);
LocalFrame local_now(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame);

}  // namespace mien::motion
