#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Finds faults that appear only when motions are made and staged, before any frame is rendered for
/// a film: examples that cannot be blended, clips without a human figure or without the requested
/// frames or the body that a format of motion files requires, films shorter than their fades,
/// sounds that cannot be read or do not fit their films, figures that cannot have the same position
/// in the picture, and luminance that cannot be equalized by any exposure. The manifest must have
/// no faults (checked_manifest.h). Takes as long as making the motions, and slightly longer if
/// luminance is equalized.
std::vector<Fault> rehearse(const Manifest& manifest);

/// Does the same with `motions`, so that the motions can be reused afterwards.
std::vector<Fault> rehearse(const Manifest& manifest, Motions& motions);

/// Returns the same study with at most `most` of its stimuli: one of each kind first, then others
/// evenly distributed over the manifest. Stimuli are of one kind if they agree in these: source,
/// adjectives or features, method, emotions of the modifications, kind of figure, set and view. The
/// stimuli of the first overlay are always kept, even if there are then more than `most`. An
/// overlay is kept if all of its stimuli are.
Manifest rehearsal_sample(const Manifest& manifest, std::size_t most);

}  // namespace mien::pipeline
