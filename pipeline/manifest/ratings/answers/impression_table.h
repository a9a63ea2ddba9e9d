#pragma once

#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

extern const TableForm impressions_form;

/// What people think of the examples.
std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales);

}  // namespace mien::pipeline
