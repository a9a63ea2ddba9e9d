#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/methods_text.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// How examples became motions, how near these came to what was asked for, and what was held.
void tell_blends(const Manifest& manifest, Motions& motions, MethodsText& text);

}  // namespace mien::pipeline
