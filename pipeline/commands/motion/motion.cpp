#include "pipeline/commands/motion/motion.h"

#include "motion/formats/motion_file.h"

namespace mien::pipeline {

Command motion_command() {
  return {
      .name = "motion",
      .summary = "Inspect, measure, check, compare, convert, blend and modify motion files",
      .commands = {motion_info_command(), motion_compare_command(), motion_convert_command(),
                   motion_blend_command(), motion_features_command(), motion_modify_command(),
                   motion_emotions_command(), motion_stream_command(), motion_lint_command()},
      .notes = "Reads " + motion::formats_read() + "; writes " + motion::formats_written() + "."};
}

}  // namespace mien::pipeline
