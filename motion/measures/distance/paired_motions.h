#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A joint that two skeletons share by name.
struct SharedJoint {
  std::string name;
  int before = -1;    ///< index in the first skeleton
  int now = -1;       ///< index in the second
  int parent = -1;    ///< nearest shared ancestor, as an index into the shared joints; −1: none
  int opposite = -1;  ///< the mirrored joint, as an index into the shared joints; the joint itself
                      ///< on the midline, −1 if missing
};

/// A uniformly sampled motion, with the world transforms of its joints.
struct SampledMotion {
  std::vector<Pose> poses;
  std::vector<JointTransforms> world;

  int frame_count() const { return static_cast<int>(poses.size()); }
};

/// Two motions sampled at the same times, with corresponding joints. Frame i is at i /
/// frames_per_second seconds after the start of each; the motions are neither aligned nor scaled.
struct PairedMotions {
  std::vector<SharedJoint> joints;  ///< in the order of the first skeleton; never empty
  std::vector<std::string> only_before, only_now;
  double frames_per_second = 30.0;  ///< of the first motion
  SampledMotion before;             ///< its original frames
  SampledMotion now;  ///< resampled to the first motion's frame rate if the rates differ
  int frames = 0;     ///< number of frames that both have

  double seconds(int frame) const { return frame / frames_per_second; }
};

/// Pairs the joints by name and the frames by time. Of several joints of one skeleton with the same
/// name only the first is paired, unless both skeletons have the same list of names. Throws Error,
/// naming the clip, if a clip has no frames or contains a non-finite number, and if the two have no
/// joint in common.
PairedMotions paired(const Clip& before, const Clip& now);

/// Whether both frame rates are equal within the rounding of files.
bool same_rate(double before, double now);

/// A joint's coordinate frame relative to its nearest shared ancestor, or to the world if it has
/// none. Where that is the joint's parent, the numbers are taken directly from the poses, so that
/// equal poses yield exactly equal coordinate frames.
struct LocalFrame {
  Vec3 offset;
  Quat rotation;
};
LocalFrame local_before(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame);
LocalFrame local_now(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame);

}  // namespace mien::motion
