#pragma once

#include <string>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// The manual page mien(1) in the macros of man(7), plain ASCII: what every `--help` says, exit
/// codes and files. `version` is "0.2.0", `date` the day of its release, "2026-11-22".
std::string manual_page(const Command& program, const std::string& version,
                        const std::string& date);

}  // namespace mien::pipeline
