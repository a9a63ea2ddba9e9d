#include "pipeline/production/design/design_warning.h"

#include <algorithm>

namespace mien::pipeline {

std::string path_of_factor(const Manifest& manifest, const std::string& factor) {
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (level_of(stimulus, factor).empty()) continue;
    const bool is_stated = std::ranges::find(stimulus.factors, factor,
                                             &Factors::value_type::first) != stimulus.factors.end();
    return is_stated ? stimulus.path + ".factors." + factor : stimulus.path;
  }
  return "stimuli";
}

}  // namespace mien::pipeline
