#include "motion/live/live_message.h"

#include "motion/live/bytes.h"

namespace mien::motion {

namespace {

/// frames × 2; a plant of a loop may go on over its seam.
std::string standing_feet(const LiveMotion& live) {
  const Clip& clip = live.motion.clip;
  const int frames = clip.frame_count();
  std::string feet(2 * clip.poses.size(), '\0');
  for (const FootPlant& plant : live.plants) {
    for (int frame = plant.first; frame <= plant.last; ++frame) {
      if (!clip.loops && (frame < 0 || frame >= frames)) continue;
      const int within = (frame % frames + frames) % frames;
      feet[static_cast<std::size_t>(2 * within + (plant.left ? 0 : 1))] = 1;
    }
  }
  return feet;
}

void add_label(ByteWriter& bytes, std::string_view label) {
  for (const char c : label) bytes.put(c);
}

void add_head(ByteWriter& bytes, const LiveMotion& live) {
  const Clip& clip = live.motion.clip;
  add_label(bytes, "MOVE");
  bytes.whole(clip.frame_count());
  bytes.whole(clip.body.size());
  bytes.flag(clip.loops);
  bytes.whole(static_cast<int>(live.motion.keytimes.size()));
  bytes.whole(static_cast<int>(live.weights.size()));
  bytes.number(clip.frames_per_second);
  bytes.vector(clip.cycle_displacement);
  for (const double keytime : live.motion.keytimes) bytes.number(keytime);
  for (const double weight : live.weights) bytes.number(weight);
}

}  // namespace

std::string to_message(const LiveMotion& live) {
  const Clip& clip = live.motion.clip;
  ByteWriter bytes;
  add_head(bytes, live);
  std::vector<JointTransforms> frames;
  for (const Pose& pose : clip.poses) frames.push_back(world_transforms(clip.body, pose));
  for (const JointTransforms& frame : frames) {
    for (const Vec3& position : frame.positions) bytes.vector(position);
  }
  for (const JointTransforms& frame : frames) {
    for (const Quat& rotation : frame.rotations) bytes.rotation(rotation);
  }
  return bytes.bytes() + standing_feet(live);
}

std::string to_message(const Distance& distance) {
  ByteWriter bytes;
  add_label(bytes, "DIST");
  bytes.whole(0);
  bytes.number(distance.mean);
  bytes.number(distance.sum);
  for (const double d : distance.by_joint()) bytes.number(d);
  for (const double d : distance.by_time()) bytes.number(d);
  return bytes.bytes();
}

}  // namespace mien::motion
