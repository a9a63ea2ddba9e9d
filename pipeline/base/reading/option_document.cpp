#include "pipeline/base/reading/option_document.h"

#include <algorithm>
#include <utility>

#include "pipeline/base/documents/paths_of_manifests.h"

namespace mien::pipeline {

namespace {

const std::string options_name = "options";

/// The option for a path: "in_place" is --in-place; what follows a dot stays as in the manifest.
std::string option_of(const std::string& path) {
  std::string name = path.substr(0, path.find_first_of(".["));
  std::ranges::replace(name, '_', '-');
  return "--" + name + path.substr(name.size());
}

}  // namespace

JsonReading read_options(const std::string& yaml, const nlohmann::json& schema,
                         const Environment& environment) {
  try {
    return read_valid_json(yaml, options_name, schema, environment);
  } catch (const Faults& faults) {
    throw as_option_faults(faults.list());
  }
}

Faults as_option_faults(std::vector<Fault> faults) {
  for (Fault& fault : faults) {
    if (!fault.place.file.empty() && fault.place.file != options_name) continue;
    fault.place = {};
    if (!fault.path.empty()) fault.path = option_of(fault.path);
    if (fault.remedy.ends_with(from_the_manifest))
      fault.remedy.resize(fault.remedy.size() - from_the_manifest.size());
  }
  return Faults(std::move(faults));
}

}  // namespace mien::pipeline
