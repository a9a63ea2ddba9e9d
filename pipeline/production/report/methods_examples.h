#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/report/methods_text.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// What the motions were made from, and what people thought of it.
void tell_examples(const Manifest& manifest, Motions& motions, MethodsText& text);

}  // namespace mien::pipeline
