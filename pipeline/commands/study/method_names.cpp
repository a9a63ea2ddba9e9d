#include "pipeline/commands/study/method_names.h"

#include <map>

#include <CLI/CLI.hpp>

#include "pipeline/commands/word_choice.h"

namespace mien::pipeline {

std::vector<motion::InterpolationMethod> methods_with_parameters() {
  using enum motion::InterpolationMethod;
  return {reach, cardinal, nearest, inverse_distance, grid, kriging, pca, incremental};
}

void add_methods_option(CLI::App& command, std::vector<motion::InterpolationMethod>& methods,
                        const std::string& otherwise) {
  std::map<std::string, motion::InterpolationMethod> by_name;
  std::string names;
  for (const motion::InterpolationMethod method : methods_with_parameters()) {
    by_name.emplace(motion::name_of(method), method);
    names += (names.empty() ? "" : ", ") + std::string(motion::name_of(method));
  }
  command
      .add_option("--methods", methods,
                  "Methods of interpolation to try, with commas: " + names + "; " + otherwise)
      ->delimiter(',')
      ->transform(choice_of(by_name))
      ->option_text("METHOD,...");
}

}  // namespace mien::pipeline
