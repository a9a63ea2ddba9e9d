#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/methods_text.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// How the motions were shown, what films have in common, and how far motions are from each other.
void tell_pictures(const Manifest& manifest, Motions& motions, MethodsText& text);

}  // namespace mien::pipeline
