#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/questionnaire/trial_subjects.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> rated_stimuli(const Manifest& manifest) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  for (const auto& stimuli : trial_subjects(manifest).stimuli) std::ranges::for_each(stimuli, add);
  std::ranges::for_each(questionnaire_of(manifest).practice, add);
  return ids;
}

/// Reads a table of assumed ratings and collects its faults.
class TruthReader {
 public:
  TruthReader(const Manifest& manifest, const CsvTable& table)
      : table_(table), scales_(questionnaire_scales(manifest)), stimuli_(rated_stimuli(manifest)) {
    for (const Scale& scale : scales_.scales) names_.push_back(scale.id);
    const TrialForm& form = *questionnaire_of(manifest).trials;
    if (form.is_detection) names_.emplace_back(form.item);
  }

  StatedTruth read() {
    const auto column = [&](const char* name) {
      return static_cast<std::size_t>(require_column(table_, name));
    };
    const std::size_t stimulus = column("stimulus"), scale = column("scale"),
                      value = column("value");
    StatedTruth truth;
    for (const std::vector<CsvField>& row : table_.rows) {
      check_known_name(row[stimulus], "stimulus", stimuli_);
      check_known_name(row[scale], "scale", names_);
      truth[{row[stimulus].text, row[scale].text}] = number(row[value], row[scale].text);
    }
    if (!faults_.empty()) throw Faults(std::move(faults_));
    return truth;
  }

 private:
  void add(const CsvField& field, std::string wrong, std::string remedy) {
    faults_.push_back({place_of(table_, field), "", std::move(wrong), std::move(remedy)});
  }

  void check_known_name(const CsvField& field, const char* what,
                        const std::vector<std::string>& known) {
    if (std::ranges::find(known, field.text) != known.end()) return;
    add(field, fmt::format("the questionnaire has no {} {}", what, motion::in_quotes(field.text)),
        motion::did_you_mean(field.text, known));
  }

  double number(const CsvField& field, const std::string& scale) {
    double value = 0.0;
    try {
      value = number_in(table_, field);
    } catch (const Error& error) {
      faults_.push_back({{}, "", error.what(), ""});
      return value;
    }
    const Scale* range = find_scale(scales_, scale);
    if (range != nullptr && (value < range->least || value > range->most))
      add(field, fmt::format("{} is outside the scale", field.text),
          fmt::format("write a number from {:g} to {:g}", range->least, range->most));
    return value;
  }

  const CsvTable& table_;
  ScaleSet scales_;
  std::vector<std::string> stimuli_;
  std::vector<std::string> names_;
  std::vector<Fault> faults_;
};

StatedTruth signal_truth(const Manifest& manifest) {
  StatedTruth truth;
  for (const std::string& id : signal_stimuli(manifest))
    truth[{id, std::string(questionnaire_of(manifest).trials->item)}] = 1.0;
  return truth;
}

}  // namespace

StatedTruth read_truth(const Manifest& manifest, const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  return TruthReader(manifest, table).read();
}

StatedTruth measured_truth(const Manifest& manifest) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if (form.has_key("signal")) return signal_truth(manifest);
  const ScaleSet scales = questionnaire_scales(manifest);
  Motions motions(manifest);
  motion::ExampleSet set;
  for (const std::string& id : rated_stimuli(manifest)) {
    set.examples.push_back(motions.of(id).motion);
    set.examples.back().name = id;
  }
  StatedTruth truth;
  for (const StyledStimulus& stimulus : measured_profiles(set)) {
    if (form.is_detection)
      truth[{stimulus.name, std::string(form.item)}] =
          std::accumulate(stimulus.profile.begin(), stimulus.profile.end(), 0.0);
    for (const Scale& scale : scales.scales) {
      const StyleProfile loadings = loadings_of(scale);
      double impression = 0.0;
      for (std::size_t i = 0; i < loadings.size(); ++i)
        impression += loadings[i] * stimulus.profile[i];
      // The mean answer of simulated raters (simulated_raters.cpp).
      truth[{stimulus.name, scale.id}] =
          0.5 * (scale.least + scale.most) +
          0.5 * (scale.most - scale.least) * std::tanh(1.2 * impression);
    }
  }
  return truth;
}

}  // namespace mien::pipeline
