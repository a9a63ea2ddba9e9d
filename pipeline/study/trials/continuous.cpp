// Continuous ratings: a marker is moved on a scale while a film plays. The raw answer is the trace
// of the marker (trace.h), its value the mean after the lead.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

/// Attention checks ask for one slider without a stimulus.
std::vector<std::string> marker_ends(const Question&) { return {"0", "100"}; }

std::string trace_fault(const Question& question, const ItemResponse& response) {
  if (question.trial.is_attention_check()) {
    const double raw =
        response.is_number ? std::strtod(response.value_raw.c_str(), nullptr) : std::nan("");
    return raw >= 0.0 && raw <= 100.0 && raw == std::floor(raw)
               ? ""
               : "an answer is no whole number from 0 to 100";
  }
  const bool is_trace = !response.is_number && read_trace(response.value_raw).has_value();
  return is_trace ? "" : "an answer is no trace of numbers from 0 to 100";
}

void complete_trace(const Question& question, AnswerRow& row) {
  row.pole_left = question.item.flipped ? "high" : "low";
  row.value.clear();
  const auto trace = read_trace(row.value_raw);
  if (!trace) return;
  if (const auto mean = mean_of_trace(*trace, question.scale->lead_s))
    row.value = shortest(written_value_of_raw(*question.scale, *mean, question.item.flipped));
}

/// Seconds in which an impression comes about: after these, 63 % of it.
constexpr double impression_seconds = 1.5;

/// Share of an opinion that is an impression, `seconds` after it is formed.
double impression_share(double seconds) {
  return seconds > 0.0 ? 1.0 - std::exp(-seconds / impression_seconds) : 0.0;
}

/// The impression begins at the start of the scale and approaches the participant's opinion; the
/// marker follows it after the reaction lag, and wanders about it. Where the opinion changes, the
/// impression approaches the changed one in the same way; being linear, it is the sum of all
/// approaches.
std::string simulated_trace(const Question& question, const SimulatedView& view) {
  const double start = question.scale->starts_low ? 0.0 : 50.0;
  const double opinion = view.opinion(0);
  std::vector<double> trace(trace_samples(view.film_seconds));
  for (std::size_t k = 0; k < trace.size(); ++k) {
    const double seen = sample_time(k, view.film_seconds) - view.reaction_lag_s;
    const double wander = k < view.wander.size() ? view.wander[k] : 0.0;
    double value = start + impression_share(seen) * (opinion - start + wander);
    for (const auto& [from_s, change] : view.changes)
      value += impression_share(seen - from_s) * change;
    const double shown = std::clamp(value, 0.0, 100.0);
    trace[k] = question.item.flipped ? 100.0 - shown : shown;
  }
  return to_text(trace);
}

}  // namespace

constinit const TrialKind continuous_trials = {.name = continuous_form.name,
                                               .form = &continuous_form,
                                               .attention_answers = marker_ends,
                                               .fault = trace_fault,
                                               .complete = complete_trace,
                                               .simulated = simulated_trace};

}  // namespace mien::pipeline
