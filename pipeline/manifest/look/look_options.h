#pragma once

#include <string>

#include "pipeline/manifest/look/look.h"

namespace mien::pipeline {

/// A look as the options of a command say it: each a name, or options in the words of a manifest,
/// with or without braces ("mannequin: {build: 0.3}"). A scene may be a file, and so may a figure
/// (of a character); paths are taken from the working folder.
struct LookOptions {
  std::string scene;  ///< empty: that of the figure's kind
  std::string figure = "stick";
  std::string camera = "three-quarter";
};

/// Throws Faults that list everything wrong with them.
Look look_of(const LookOptions& options);

}  // namespace mien::pipeline
