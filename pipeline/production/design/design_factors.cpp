#include "pipeline/production/design/design_factors.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

bool states(const Stimulus& stimulus, const std::string& factor) {
  return std::ranges::find(stimulus.factors, factor, &Factors::value_type::first) !=
         stimulus.factors.end();
}

}  // namespace

bool is_stated(const Manifest& manifest, const std::string& factor) {
  return std::ranges::any_of(manifest.stimuli,
                             [&](const Stimulus& one) { return states(one, factor); });
}

std::vector<std::string> design_factors(const Manifest& manifest) {
  std::vector<std::string> names = factors_of(manifest);
  std::erase_if(names, [&](const std::string& name) {
    return name != "emotion" && !is_stated(manifest, name);
  });
  return names;
}

std::string path_of_factor(const Manifest& manifest, const std::string& factor) {
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (states(stimulus, factor)) return stimulus.path + ".factors." + factor;
    if (!level_of(stimulus, factor).empty()) return stimulus.path;
  }
  return "stimuli";
}

}  // namespace mien::pipeline
