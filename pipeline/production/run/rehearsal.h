#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// What only shows when motions are made and staged, found before a frame is drawn for a film:
/// examples that cannot be blended, clips that hold no human or not the requested frames, films
/// shorter than their fades, figures that no place of the picture suits, and light that no exposure
/// equalizes. The manifest itself is without faults (checked_manifest.h). Takes as long as the
/// motions of a run, and a little more where luminance is equalized.
std::vector<Fault> rehearse(const Manifest& manifest);

/// Makes the motions in `motions`, so that they can be used afterwards.
std::vector<Fault> rehearse(const Manifest& manifest, Motions& motions);

/// The same study with at most so many of its stimuli: one of each kind first, then some that are
/// spread over the others. A kind is what stimuli are that differ in numbers alone: made from the
/// same adjectives in the same way, and shown as the same figure on the same set. Overlays stay
/// where their stimuli do, and so does the first.
Manifest rehearsal_sample(const Manifest& manifest, std::size_t most);

}  // namespace mien::pipeline
