#pragma once

#include <optional>

#include "pipeline/manifest/output.h"
#include "pipeline/tasks/store.h"
#include "render/image/image.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// Returns the decoded frame from the store, or nothing if it must be rendered again: there is no
/// store, the store has no such frame with the film's key, or the stored frame cannot be decoded
/// and is discarded.
std::optional<render::Image8> reusable_frame(FrameStore* store, int frame, const Output& output,
                                             const render::Tone& tone);

}  // namespace mien::pipeline
