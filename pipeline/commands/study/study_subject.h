#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

struct Console;

/// What a study command is about, as its options say it.
struct StudySubject {
  std::string examples;  ///< a manifest (.yaml), or what `parse_examples` takes
  std::string ratings;   ///< CSV; empty: the manifest's, or those of a built-in set
  std::string scales;    ///< YAML; empty: the manifest's, or the built-in pairs
};

/// The manifest with what the options say over it, or one of the options alone. A manifest that is
/// not there is looked for among the installed ones. Throws Error.
Manifest manifest_of(const StudySubject& subject, const Console& console);

}  // namespace mien::pipeline
