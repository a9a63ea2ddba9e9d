#include "pipeline/commands/study/method_names.h"

namespace mien::pipeline {

std::vector<motion::InterpolationMethod> methods_with_parameters() {
  using enum motion::InterpolationMethod;
  return {reach, cardinal, nearest, inverse_distance, grid, kriging, pca, incremental};
}

CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise) {
  WordValues<motion::InterpolationMethod> by_name;
  for (const motion::InterpolationMethod method : methods_with_parameters())
    by_name.emplace_back(motion::name_of(method), method);
  return choice("--methods", methods, by_name,
                "Methods of interpolation to try, with commas; " + otherwise);
}

}  // namespace mien::pipeline
