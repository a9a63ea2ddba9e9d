#include "motion/formats/reading/recording_limits.h"

#include <string>

namespace mien::motion {

namespace {

constexpr size_t most_joints = 65'536;
constexpr size_t most_rotations = size_t{1} << 27;

}  // namespace

bool is_reasonable_size(size_t joints, size_t frames) {
  return joints <= most_joints && (joints == 0 || frames <= most_rotations / joints);
}

void require_reasonable_size(const Place& place, size_t joints, size_t frames) {
  if (is_reasonable_size(joints, frames)) return;
  if (joints > most_joints) {
    throw Error(place, "more than " + std::to_string(most_joints) + " joints",
                "keep the joints of one figure");
  }
  throw Error(
      place,
      std::to_string(frames) + " frames of " + std::to_string(joints) + " joints are too many",
      "cut the motion into shorter files");
}

}  // namespace mien::motion
