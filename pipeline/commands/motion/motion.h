#pragma once

#include "pipeline/commands/cli.h"

namespace mien::pipeline {

// The subcommands of `mien motion`; each adds itself to `motion`.
void add_motion_info_command(CLI::App& motion, Command& chosen);
void add_motion_compare_command(CLI::App& motion, Command& chosen);
void add_motion_convert_command(CLI::App& motion, Command& chosen);
void add_motion_blend_command(CLI::App& motion, Command& chosen);
void add_motion_features_command(CLI::App& motion, Command& chosen);
void add_motion_modify_command(CLI::App& motion, Command& chosen);
void add_motion_emotions_command(CLI::App& motion, Command& chosen);
void add_motion_lint_command(CLI::App& motion, Command& chosen);
void add_motion_stream_command(CLI::App& motion, Command& chosen);

}  // namespace mien::pipeline
