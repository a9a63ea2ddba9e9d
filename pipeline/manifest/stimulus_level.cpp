#include "pipeline/manifest/stimulus_level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

namespace {

/// "0, 0.1, …, 1"; all values if they are few.
std::string listed_levels(const std::vector<std::string>& texts) {
  constexpr std::size_t few = 4;
  if (texts.size() <= few) return fmt::format("{}", fmt::join(texts, ", "));
  return fmt::format("{}, {}, …, {}", texts[0], texts[1], texts.back());
}

}  // namespace

void StimulusLevelForm::read(const DocumentValue& given, StimulusLevel& level) {
  assign(member(given.value, "factor"), level.factor);
  assign(member(given.value, "of"), level.option);
  const nlohmann::json* values = member(given.value, "values");
  if (values != nullptr && values->is_array() && !values->empty() && values->front().is_number())
    level.text = shortest(values->front().get<double>());
}

OrderedJson StimulusLevelForm::write(const StimulusLevel&, const WritingOptions&) { return {}; }

std::vector<std::string> levels_made(const Manifest& manifest) {
  std::vector<std::string> made;
  for (std::size_t i = 0; i < manifest.origins.size();) {
    const Stimulus& first = manifest.stimuli[i];
    std::vector<std::string> texts;
    for (const std::size_t origin = manifest.origins[i];
         i < manifest.origins.size() && manifest.origins[i] == origin; ++i)
      texts.push_back(manifest.stimuli[i].level.text);
    if (first.level.factor.empty()) continue;
    const std::size_t ending = first.level.text.size() + 1;
    made.push_back(fmt::format("{}: {} levels of {} ({}): {}",
                               first.id.substr(0, first.id.size() - ending), texts.size(),
                               first.level.factor, first.level.option, listed_levels(texts)));
  }
  return made;
}

}  // namespace mien::pipeline
