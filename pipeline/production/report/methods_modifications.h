#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/methods_text.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// What was done to motions afterwards, and which of them are foils.
void tell_modifications(const Manifest& manifest, Motions& motions, MethodsText& text);

}  // namespace mien::pipeline
