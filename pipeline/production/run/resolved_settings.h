#pragma once

#include "pipeline/base/reading/field_values.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Every setting of a stimulus or of an overlay's film as it was used, defaults and recipes filled
/// in: look, output, interpolation, each modification with its seed. Files are told by their names.
OrderedJson resolved_settings(const Stimulus& stimulus);
OrderedJson resolved_settings(const Overlay& overlay);

}  // namespace mien::pipeline
