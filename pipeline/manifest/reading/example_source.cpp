#include "pipeline/manifest/reading/example_source.h"

#include <filesystem>
#include <optional>
#include <string_view>

#include "motion/error.h"
#include "motion/text/as_number.h"

namespace mien::pipeline {

namespace {

double share(std::string_view text, std::string_view whole) {
  const auto value = motion::as_finite_number(text);
  if (value && *value >= 0.0) return *value;
  throw Error("--weights: \"" + std::string(whole) + "\" has no weight",
              "write name=weight with a weight of at least 0, for example normal=0.6,proud=0.4");
}

}  // namespace

Examples parse_examples(const std::string& text) {
  constexpr std::string_view prefix = "builtin:";
  Examples examples;
  if (text.starts_with(prefix)) {
    examples.builtin = text.substr(prefix.size());
    examples.blendable = examples.builtin != unblendable_set;
    refuse_unblendable(examples);
    return examples;
  }
  const std::filesystem::path path(text);
  if (std::filesystem::is_directory(path)) {
    examples.folder = path;
    return examples;
  }
  examples.folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  examples.include = path.filename().string();
  return examples;
}

void refuse_unblendable(const Examples& examples) {
  if (examples.blendable) return;
  throw Error("the examples of this set cannot be blended",
              "use builtin:walks-10, or a folder without blend: false");
}

NamedValues parse_weights(const std::string& text) {
  NamedValues weights;
  double sum = 0.0;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    const std::size_t equals = one.find('=');
    const std::string name(one.substr(0, equals));
    const double value = share(equals == std::string_view::npos ? "" : one.substr(equals + 1), one);
    weights.emplace_back(name, value);
    sum += value;
  }
  if (sum > 0.0) return weights;
  throw Error("--weights: all weights are 0", "give at least one example a weight");
}

}  // namespace mien::pipeline
