#pragma once

#include <optional>

#include "pipeline/manifest/output.h"
#include "pipeline/tasks/store.h"
#include "render/image/image.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// The frame as the store has it, decoded. Nothing where it has to be drawn again: the store has no
/// frame of that name with the film's key, or what it has does not decode, and is thrown away.
std::optional<render::Image8> reusable_frame(FrameStore* store, int frame, const Output& output,
                                             const render::Tone& tone);

}  // namespace mien::pipeline
