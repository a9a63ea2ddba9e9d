#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/base/documents/places.h"
#include "pipeline/commands/line/command.h"
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
  /// --size, --scale, …, which must not outlive this.
  std::vector<CommandOption> options();

  /// Throws Faults for what the schema does not allow.
  OutputReading read() const;

 private:
  CommandOption option_of(const std::string& key);

  std::map<std::string, std::string> given_;  ///< key → YAML text
  std::map<std::string, bool> is_array_;
};

}  // namespace mien::pipeline
