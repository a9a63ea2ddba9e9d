#include "pipeline/study/power/planned_power.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/power/design_size.h"
#include "pipeline/study/power/one_size_power.h"

namespace mien::pipeline {

namespace {

/// Sorts rows by test, planned contrasts first as in the figure, otherwise in the order in which
/// tests first occur.
void sort_by_test(std::vector<PlannedTestPower>& rows) {
  std::map<std::tuple<bool, std::string, std::string, TestedBy>, std::size_t> order;
  const auto key = [](const PlannedTestPower& row) {
    return std::tuple(row.is_contrast, row.name, row.scale, row.by);
  };
  for (const PlannedTestPower& row : rows) order.try_emplace(key(row), order.size());
  std::ranges::stable_sort(rows, {}, [&](const PlannedTestPower& row) {
    return std::pair(!row.is_contrast, order.at(key(row)));
  });
}

void check_size(const Manifest& manifest, const PlannedPowerOptions& options) {
  const auto stimuli = static_cast<double>(
      std::max(questionnaire_stimuli(manifest).size(), questionnaire_subject_count(manifest)));
  const auto scales = static_cast<double>(questionnaire_scales(manifest).scales.size());
  const double answers = stimuli * scales * options.participants.back() * options.studies;
  if (answers <= most_simulated_answers) return;
  throw Error(fmt::format("{:.2g} answers would have to be simulated", answers),
              "simulate fewer studies (--studies), participants or stimuli");
}

}  // namespace

const RatingSpread& spread_for(const std::vector<ScaleSpread>& spreads, const std::string& scale) {
  for (const ScaleSpread& one : spreads)
    if (one.scale == scale || one.scale.empty()) return one.spread;
  throw Error(fmt::format("the ratings have none on the scale {}, which is asked", scale),
              "give ratings on all scales, or --spread");
}

void set_power(PlannedTestPower& row, int found, int alarms, int studies) {
  row.studies = studies;
  if (studies == 0) return;
  row.power = simulated_share(found, studies);
  row.power_error = std::sqrt(row.power.share * (1.0 - row.power.share) / studies);
  row.false_positives = simulated_share(alarms, studies);
}

std::vector<PlannedTestPower> planned_power(const Manifest& manifest,
                                            const PlannedPowerOptions& options) {
  std::vector<int> sizes = options.stimuli_per_cell;
  if (sizes.empty()) sizes = {0};
  std::vector<PlannedTestPower> all;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Manifest sized = sizes[i] == 0 ? manifest : with_stimuli_per_cell(manifest, sizes[i]);
    const int per_cell = sizes[i] == 0 ? stimuli_per_cell(manifest) : sizes[i];
    check_size(sized, options);
    const auto progress = [&](double share) {
      if (options.progress)
        options.progress((static_cast<double>(i) + share) / static_cast<double>(sizes.size()));
    };
    const std::vector<PlannedTestPower> rows =
        analysed_answers(manifest) == AnalysedAnswers::choices
            ? pair_power(sized, options, per_cell, progress)
            : rating_power(sized, options, per_cell, progress);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  sort_by_test(all);
  return all;
}

}  // namespace mien::pipeline
