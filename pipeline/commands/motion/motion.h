#pragma once

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

// The subcommands of `mien motion`.
Command motion_info_command();
Command motion_compare_command();
Command motion_convert_command();
Command motion_blend_command();
Command motion_features_command();
Command motion_modify_command();
Command motion_emotions_command();
Command motion_lint_command();
Command motion_stream_command();

}  // namespace mien::pipeline
