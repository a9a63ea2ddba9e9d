#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A modification of a motion given on the command line.
struct Change {
  std::string in;      ///< motion file; empty if the motion arrives as a stream
  std::string change;  ///< an emotion, or the value of `modify:` in a manifest
  std::string recipes = "builtin";
  std::string on_fault = "warn";
};

/// The equivalent stimulus of a manifest. Throws Faults, whose messages do not refer to that
/// manifest.
Stimulus stimulus_of(const Change& change);

}  // namespace mien::pipeline
