#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// `version` of a program: its own version, the libraries that have a part in artifacts' bytes, and
/// `more` that this program alone has.
Command version_command(std::string summary, std::vector<std::pair<std::string, std::string>> more);

}  // namespace mien::pipeline
