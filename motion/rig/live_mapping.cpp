#include "motion/rig/live_mapping.h"

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/rig/rest_calibration.h"
#include "motion/rig/rig_motion.h"

namespace mien::motion {

LiveMapping::LiveMapping(const Recording& first) : mapping_(recognise(first)), now_(first) {
  if (!rest_calibration(rig_motion(first, mapping_.joints, mapping_.to_y_up))) {
    throw Error(Place{first.name},
                "its rig does not stand when all angles are zero, so the orientation of its limbs "
                "cannot be derived from the hierarchy and one frame",
                "give a recording of the same rig to calibrate with (--calibration)");
  }
  floor_ = recorded_floor(first, mapping_);
}

LiveMapping::LiveMapping(const Recording& calibration, const Recording& first) : now_(first) {
  if (!same_rig(calibration.skeleton, first.skeleton)) {
    throw Error(Place{calibration.name}, "its rig differs from that of the stream",
                "calibrate with a recording of the same joints, offsets and unit");
  }
  mapping_ = recognise(calibration);
  floor_ = recorded_floor(calibration, mapping_);
}

Pose LiveMapping::operator()(const Pose& pose) {
  now_.poses.front() = pose;
  Pose mapped = std::move(to_body(now_, mapping_, floor_).poses.front());
  // Whether fingers were recorded does not follow from one frame, and a stream keeps its joints.
  mapped.fingers.clear();
  for (size_t j = 0; j < before_.rotations.size(); ++j) {
    mapped.rotations[j] = in_hemisphere_of(before_.rotations[j], mapped.rotations[j]);
  }
  before_ = mapped;
  return mapped;
}

}  // namespace mien::motion
