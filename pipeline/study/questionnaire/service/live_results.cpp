#include "pipeline/study/questionnaire/service/live_results.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "pipeline/manifest/ratings/answers/counted_answers.h"

namespace mien::pipeline {

namespace {

constexpr int slider_bins = 10;

/// Labels of the bins of a scale: its values, or parts of a slider by their middles.
std::vector<std::string> bin_labels(const ResponseScale& scale) {
  std::vector<std::string> labels;
  if (scale.words) return labels;
  const int bins = scale.slider ? slider_bins : scale.points;
  const double width = scale.most - scale.least;
  for (int bin = 0; bin < bins; ++bin) {
    const double value = scale.slider ? scale.least + (bin + 0.5) * width / bins
                                      : written_value_of_raw(scale, bin + 1, false);
    labels.push_back(fmt::format("{:g}", value));
  }
  return labels;
}

std::size_t bin_of(const ResponseScale& scale, double value) {
  const int bins = scale.slider ? slider_bins : scale.points;
  const double share = (value - scale.least) / (scale.most - scale.least);
  const double place = scale.slider ? std::floor(share * bins) : std::round(share * (bins - 1));
  return static_cast<std::size_t>(std::clamp(place, 0.0, bins - 1.0));
}

}  // namespace

const ResponseScale* LiveResults::scale_of(const AnswerRow& row) const {
  return is_on_scale(row) ? find_scale(facts_.scales, row.item) : nullptr;
}

LiveResults::Tally& LiveResults::tally_of(const AnswerRow& row) {
  const TrialForm& form = *find_trial_form(row.kind);
  const auto [found, is_new] =
      tallies_.try_emplace({row.item, form.stimuli > 1 && !form.is_on_scale});
  if (!is_new) return found->second;
  if (form.offers_choices && row.item == form.item) found->second.labels = facts_.choices;
  if (const ResponseScale* scale = scale_of(row)) found->second.labels = bin_labels(*scale);
  found->second.counts.resize(found->second.labels.size());
  return found->second;
}

void LiveResults::count(Tally& tally, const std::string& label) {
  const auto found = std::ranges::find(tally.labels, label);
  if (found != tally.labels.end()) {
    ++tally.counts[static_cast<std::size_t>(found - tally.labels.begin())];
    return;
  }
  tally.labels.push_back(label);
  tally.counts.push_back(1);
}

void LiveResults::clear() {
  tallies_.clear();
  passed_ = failed_ = 0;
}

void LiveResults::add(const std::vector<AnswerRow>& rows) {
  for (const AnswerRow& row : rows) {
    if (row.passed) ++(*row.passed ? passed_ : failed_);
    if (!row.counts()) continue;
    Tally& tally = tally_of(row);
    ++tally.answers;
    const ResponseScale* scale = scale_of(row);
    if (scale == nullptr) {
      count(tally, row.value);
    } else if (!scale->words) {
      const double value = std::strtod(row.value.c_str(), nullptr);
      tally.sum += value;
      tally.is_measured = true;
      ++tally.counts[bin_of(*scale, value)];
    }
  }
}

nlohmann::ordered_json LiveResults::histograms() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [key, tally] : tallies_) {
    nlohmann::ordered_json bins = nlohmann::ordered_json::array();
    for (std::size_t at = 0; at < tally.labels.size(); ++at)
      bins.push_back({{"label", tally.labels[at]}, {"count", tally.counts[at]}});
    nlohmann::ordered_json one = {{"item", key.first},
                                  {"is_pair", key.second},
                                  {"answers", tally.answers},
                                  {"mean", nullptr}};
    if (tally.is_measured) one["mean"] = tally.sum / tally.answers;
    one["bins"] = std::move(bins);
    list.push_back(std::move(one));
  }
  return list;
}

nlohmann::ordered_json LiveResults::checks() const {
  return {{"passed", passed_}, {"failed", failed_}};
}

}  // namespace mien::pipeline
