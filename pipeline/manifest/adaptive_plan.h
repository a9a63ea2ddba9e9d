#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The extent of an adaptive experiment. The manifest must have one.

/// Returns all names that a kind of dimensions knows, without reading a motion: groups, scales,
/// features, or examples as far as their files exist. Components and recipes have none.
std::vector<std::string> known_dimensions(const Manifest& manifest, MotionSpace::Kind kind);

/// Returns the dimensions of the space in their order: those named, or all of their kind (of
/// features the four groups); components are named "component-1", "component-2" and so on, those of
/// a recipe as dimensions_of names them.
std::vector<std::string> dimension_names(const Manifest& manifest);

/// Returns the number of dimensions; 0 if the examples are not known.
std::size_t dimension_count(const Manifest& manifest);

/// Returns the number of steps of a complete chain, or its greatest number (until): in Gibbs
/// sampling one for each dimension in each sweep, otherwise one for each choice.
double chain_steps(const Manifest& manifest);

}  // namespace mien::pipeline
