#include <algorithm>
#include <iterator>

#include "motion/text/nearest_word.h"
#include "pipeline/manifest/checks/part_checks.h"

namespace mien::pipeline {

std::vector<Fault> check_design(const Manifest& manifest) {
  FaultList list(manifest.places);
  const std::vector<std::string> factors = factors_of(manifest);
  for (const auto& [factor, names] : manifest.design.varies) {
    const std::string path = member_path("design.varies", factor);
    if (std::ranges::find(factors, factor) == factors.end())
      list.add_at_key(path, "unknown factor", motion::did_you_mean(factor, factors));
    std::vector<std::string> known;
    for (const StimulusProperty& property : stimulus_properties) known.emplace_back(property.id);
    std::ranges::copy_if(factors, std::back_inserter(known),
                         [&name = factor](const std::string& other) { return other != name; });
    for (std::size_t i = 0; i < names.size(); ++i)
      list.check_known_name(element_path(path, i), names[i], "property", known);
  }
  for (std::size_t i = 0; i < manifest.design.alike.size(); ++i)
    list.check_known_name(element_path("design.alike", i), manifest.design.alike[i], "factor",
                          factors);
  return list.take();
}

}  // namespace mien::pipeline
