#pragma once

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

Command regress_command();

}  // namespace mien::pipeline
