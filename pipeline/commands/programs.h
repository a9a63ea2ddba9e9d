#pragma once

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// The commands of `mien`, without the subcommands of other programs.
Command mien_program();

Command check_command();
Command clean_command();
Command completion_command();
Command farm_command();
Command man_command();
Command manifests_command();
Command motion_command();
Command pack_command();
Command plan_command();
Command render_command();
Command run_command();
Command sets_command();
Command verify_command();

}  // namespace mien::pipeline
