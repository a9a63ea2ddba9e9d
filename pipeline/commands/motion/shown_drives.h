#pragma once

#include <nlohmann/json_fwd.hpp>

#include "motion/skeleton/clip.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The drives found in a motion (motion/animate/body_drive.h), for `mien motion info`: as JSON, and
/// as lines of text, none if there are none.
nlohmann::ordered_json drives_as_json(const motion::Clip& clip);
void show_drives(const motion::Clip& clip, const Console& console);

}  // namespace mien::pipeline
