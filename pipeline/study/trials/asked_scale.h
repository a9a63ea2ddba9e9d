#pragma once

#include <map>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// A scale, and how it is answered. Raw answers go from the left, whichever end of the scale is
/// there: 1 … points, or 0 … 100 of a slider.
struct AskedScale {
  int points = 5;
  bool slider = false;
  bool words = false;   ///< free words, which lie nowhere on the scale
  double least = -2.0;  ///< the answer that means the low end
  double most = 2.0;
  std::string low, high;  ///< words for the ends
};

/// By item.
using AskedScales = std::map<std::string, AskedScale>;

/// All scales that a manifest's questionnaire asks.
AskedScales asked_scales_by_item(const Manifest& manifest);

/// The scale of an item; nullptr where the item is none.
const AskedScale* find_scale(const AskedScales& scales, const std::string& item);

double least_raw(const AskedScale& scale);
double most_raw(const AskedScale& scale);

/// The answer in the scale's own range, its high end being the most.
double value_of_raw(const AskedScale& scale, double raw, bool flipped);

/// The same with the six decimals that pages and servers write.
double written_value_of_raw(const AskedScale& scale, double raw, bool flipped);

/// The raw answer nearest to a value, within the range.
double raw_of_value(const AskedScale& scale, double value, bool flipped);

}  // namespace mien::pipeline
