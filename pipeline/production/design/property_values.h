#pragma once

#include <array>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The value of a property of a stimulus: a text or a number, NaN if unknown.
struct PropertyValue {
  std::string text;
  double number = std::numeric_limits<double>::quiet_NaN();
};

/// The property `sound` of a stimulus that has none; of others it is the name of the file.
inline constexpr char without_sound[] = "without";

/// The properties of one stimulus, in the order of stimulus_properties.
using PropertyValues = std::array<PropertyValue, std::size(stimulus_properties)>;

/// Returns the properties of all stimuli as far as they are known before films are rendered: not
/// luminance and loudness, nor duration and height of the figure if they are equalized. Makes and
/// stages the motions. Throws Error.
std::vector<PropertyValues> planned_properties(const Manifest& manifest, Motions& motions);

/// Returns the properties of all stimuli, from the records of the films in the study's folder.
std::vector<PropertyValues> filmed_properties(const Manifest& manifest, Motions& motions,
                                              const std::filesystem::path& folder);

}  // namespace mien::pipeline
