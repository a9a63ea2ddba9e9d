#include "pipeline/commands/motion/motion.h"

namespace mien::pipeline {

Command motion_command() {
  return {.name = "motion",
          .summary = "Inspect, measure, check, compare, convert and blend motion files",
          .commands = {motion_info_command(), motion_compare_command(), motion_convert_command(),
                       motion_blend_command(), motion_features_command(), motion_modify_command(),
                       motion_emotions_command(), motion_stream_command(), motion_lint_command()},
          .notes = "Reads BVH, AMC (with its ASF), glTF and GLB; writes BVH and GLB."};
}

}  // namespace mien::pipeline
