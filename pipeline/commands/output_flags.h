#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/output.h"

namespace mien::pipeline {

/// An output as the options of a command say it, and where they say it ("size", "crop", …).
struct OutputReading {
  Output output;
  Places places;
};

/// The options of `output:` in a manifest that concern the picture, as options of a command: named,
/// described and limited as the manifest's schema does it.
class OutputFlags {
 public:
  /// Adds --size, --scale, … to the command, which must not outlive this.
  void add_to(CLI::App& command);

  /// Throws Faults for what the schema does not allow.
  OutputReading read() const;

 private:
  void add(CLI::App& command, const std::string& key);

  std::map<std::string, std::string> given_;  ///< key → YAML text
  std::map<std::string, bool> is_array_;
};

}  // namespace mien::pipeline
