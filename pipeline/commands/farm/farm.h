#pragma once

#include "pipeline/commands/cli.h"

namespace mien::pipeline {

// Subcommands of `mien farm`, one a source file; each adds itself to `farm`.
void add_farm_worker_command(CLI::App& farm, Command& chosen);

}  // namespace mien::pipeline
