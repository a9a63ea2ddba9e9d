#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/methods_text.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Every setting of films and of how their motions are interpolated that is another than it would
/// be if nothing were said, but for those that the other sentences tell of all films; and how many
/// dots point lights have, of what size.
void tell_settings(const Manifest& manifest, Motions& motions, MethodsText& text);

/// Likewise of the folder of examples.
void tell_example_settings(const Manifest& manifest, MethodsText& text);

/// In which order guesses and matches of a matching experiment come, and what plays beside, where
/// that is another than it would be.
void tell_matching_settings(const Manifest& manifest, MethodsText& text);

}  // namespace mien::pipeline
