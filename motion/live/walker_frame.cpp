#include "motion/live/walker_frame.h"

#include <array>
#include <cstdio>

namespace mien::motion {

namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::string vector_of(const Vec3& v) {
  return "[" + number(v.x()) + "," + number(v.y()) + "," + number(v.z()) + "]";
}

/// "name":[one,one,…]
template <class List, class Write>
std::string listed(const std::string& name, const List& list, Write&& write) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "" : ",") + write(one);
  return quoted(name) + ":[" + text + "]";
}

}  // namespace

std::string walker_info(const LiveWalk& walk, const std::string& set) {
  const std::vector<Joint>& joints = walk.gaits.body.joints;
  const std::string body =
      listed("names", joints, [](const Joint& joint) { return quoted(joint.name); }) + "," +
      listed("parents", joints, [](const Joint& joint) { return std::to_string(joint.parent); }) +
      "," + listed("offsets", joints, [](const Joint& joint) { return vector_of(joint.offset); }) +
      "," + listed("tips", joints, [](const Joint& joint) {
        return joint.tip ? vector_of(*joint.tip) : std::string("null");
      });
  return "{\"set\":" + quoted(set) + "," + listed("moods", walk.moods, quoted) + ",\"body\":{" +
         body + "}}";
}

void write_frame(const LiveWalk& walk, const Pose& pose, std::vector<double>& frame) {
  frame.clear();
  const JointTransforms joints = world_transforms(walk.gaits.body, pose);
  for (const Vec3& place : joints.positions)
    frame.insert(frame.end(), {place.x(), place.y(), place.z()});
  for (const Quat& turn : joints.rotations)
    frame.insert(frame.end(), {turn.x(), turn.y(), turn.z(), turn.w()});
  for (const SteppingLeg& leg : walk.walker.legs) frame.push_back(leg.swinging ? 0.0 : 1.0);
  frame.push_back(walk.walker.carriage.speed.value);
  frame.push_back(walk.walker.carriage.heading / radians_per_degree);
}

}  // namespace mien::motion
