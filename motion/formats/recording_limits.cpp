#include "motion/formats/recording_limits.h"

#include <string>

namespace mien::motion {

void require_reasonable_size(const Place& place, size_t joints, size_t frames) {
  constexpr size_t most_joints = 65'536;
  constexpr size_t most_rotations = size_t{1} << 27;
  if (joints > most_joints) {
    throw Error(place, "more than " + std::to_string(most_joints) + " joints",
                "keep the joints of one figure");
  }
  if (joints > 0 && frames > most_rotations / joints) {
    throw Error(place,
                std::to_string(frames) + " frames of " + std::to_string(joints) +
                    " joints are more than can be held",
                "cut the motion into shorter files");
  }
}

}  // namespace mien::motion
