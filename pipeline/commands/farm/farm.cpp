#include "pipeline/commands/farm/farm.h"

#include <CLI/CLI.hpp>

namespace mien::pipeline {

void add_farm_command(CLI::App& app, Command& chosen) {
  CLI::App* farm = app.add_subcommand("farm", "Studies on many machines");
  farm->require_subcommand(1);
  add_farm_worker_command(*farm, chosen);
}

}  // namespace mien::pipeline
