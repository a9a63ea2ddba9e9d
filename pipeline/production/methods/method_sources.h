#pragma once

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/manifest/style_step.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

/// A way of interpolation in words, and the keys of the references that it is from.
struct MethodWords {
  motion::InterpolationMethod method;
  std::string words;
  Names sources;
};

/// Of that method.
MethodWords words_of(motion::InterpolationMethod method);

/// The key of the reference that an older method is from.
std::string source_of(StyleMethod method);

}  // namespace mien::pipeline
