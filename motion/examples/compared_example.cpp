#include "motion/examples/compared_example.h"

#include "motion/examples/make_example.h"
#include "motion/examples/settled_feet.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/gait/contact.h"
#include "motion/rig/body_mapping.h"

namespace mien::motion {

namespace {

/// Whether feet that stand stand still in the world; those of a walk on the spot do not.
bool travels_or_stands(const Clip& clip) { return !stays_in_place(clip); }

}  // namespace

Example compared_example(const Recording& recording, bool settle) {
  Example example = make_example(to_body(recording));
  if (settle && travels_or_stands(example.clip)) example.clip = with_settled_feet(example.clip);
  return example;
}

Example compared_example_as_written(const Clip& clip, bool settle) {
  return compared_example(as_read_from_bvh(to_recording(clip)), settle);
}

}  // namespace mien::motion
