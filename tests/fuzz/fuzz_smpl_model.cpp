// Any bytes are a model that gives the joints finite places, or are refused.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/formats/smpl/smpl_model.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  constexpr std::array<double, 3> betas = {0.5, -1.0, 2.0};
  Skeleton skeleton = smpl_skeleton(22);
  try {
    set_smpl_proportions(skeleton, file, "fuzz.npz", betas);
  } catch (const mien::Error&) {
    return 0;
  }
  if (!is_well_formed(skeleton)) std::abort();
  for (const Joint& joint : skeleton.joints) {
    if (!joint.offset.allFinite()) std::abort();
  }
  return 0;
}
