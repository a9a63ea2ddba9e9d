#pragma once

#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/render_options.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// The most people of one file that are shown together.
inline constexpr int most_people_shown = 8;

/// The motions of a film and how they are placed.
struct RenderedMotions {
  std::vector<scenes::Performance> performances;  ///< at the film's frame rate
  scenes::Layout layout = scenes::Layout::superimposed;
};

/// Reads the motions to render and prints warnings about them: one in neutral colours; or a target,
/// the motion created to match it, and a reference; or, with `--subject all`, everyone in a file
/// where they were recorded, over the frames in which all of them are known. Throws Error for files
/// that cannot be read, and for more than `most_people_shown` people.
RenderedMotions rendered_motions(const RenderOptions& options, const Output& output,
                                 const Console& console);

}  // namespace mien::pipeline
