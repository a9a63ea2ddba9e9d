#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A change of a motion as it is given on the command line.
struct Change {
  std::string in;      ///< motion file; empty when the motion is still to come
  std::string change;  ///< an emotion, or what stands behind `modify:` in a manifest
  std::string recipes = "builtin";
  std::string on_fault = "warn";
};

/// The stimulus that a manifest would have for it. Throws Faults, named as somebody reads them who
/// has written no manifest.
Stimulus stimulus_of(const Change& change);

}  // namespace mien::pipeline
