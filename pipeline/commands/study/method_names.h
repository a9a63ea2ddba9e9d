#pragma once

#include <string>
#include <vector>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// Methods of interpolation that take parameters; shares of the examples are an interface of their
/// own.
std::vector<motion::InterpolationMethod> methods_with_parameters();

/// The option --methods; `otherwise` says what happens without it.
CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise);

}  // namespace mien::pipeline
