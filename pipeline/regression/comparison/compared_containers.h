#pragma once

#include <string>
#include <vector>

#include "render/video/video.h"

namespace mien::pipeline {

/// What two files of videos say beside their pixels. `seen` gets what people see: frames at other
/// moments, another duration (both to the unit of time of the two containers: Matroska counts
/// milliseconds), colours that are shown otherwise. `kept` gets what nobody sees: codec and pixel
/// format.
void compare_containers(const render::VideoSummary& before, const render::VideoSummary& now,
                        std::vector<std::string>& seen, std::vector<std::string>& kept);

}  // namespace mien::pipeline
