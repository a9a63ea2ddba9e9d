#pragma once

#include <cstddef>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The same study with at most so many of its stimuli: one of each kind first, then some that are
/// spread over the others. A kind is what stimuli are that differ in numbers alone: made from the
/// same adjectives in the same way, and shown as the same figure on the same set. Overlays stay
/// where their stimuli do, and so does the first.
Manifest rehearsal_sample(const Manifest& manifest, std::size_t most);

}  // namespace mien::pipeline
