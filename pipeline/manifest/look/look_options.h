#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/look/look.h"

namespace mien::pipeline {

/// A look given by command-line options: each is a name, or options in the syntax of a manifest
/// with or without braces ("mannequin: {build: 0.3}"). A scene, a figure (a character) or a face (a
/// table of weights) may also be a file; paths are relative to the working folder.
struct LookOptions {
  std::string scene;  ///< empty: the default of the figure's kind
  std::string figure = "stick";
  std::string hands = "auto";
  std::string camera = "three-quarter";
  std::string face;  ///< empty: neutral
};

/// Returns the look. Adds warnings about options with former names to `warnings`. Throws Faults
/// that list all faults of the options.
Look look_of(const LookOptions& options, std::vector<Fault>& warnings);

}  // namespace mien::pipeline
