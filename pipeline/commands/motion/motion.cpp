#include "pipeline/commands/motion/motion.h"

#include <CLI/CLI.hpp>

namespace mien::pipeline {

void add_motion_command(CLI::App& app, Command& chosen) {
  CLI::App* motion = app.add_subcommand(
      "motion", "Look at, measure, check, compare, convert and blend motion files");
  motion->require_subcommand(1);
  add_motion_info_command(*motion, chosen);
  add_motion_compare_command(*motion, chosen);
  add_motion_convert_command(*motion, chosen);
  add_motion_blend_command(*motion, chosen);
  add_motion_features_command(*motion, chosen);
  add_motion_modify_command(*motion, chosen);
  add_motion_emotions_command(*motion, chosen);
  add_motion_stream_command(*motion, chosen);
  add_motion_lint_command(*motion, chosen);
  motion->footer("\nReads BVH, AMC (with its ASF), glTF and GLB; writes BVH and GLB.");
}

}  // namespace mien::pipeline
