#include "pipeline/study/analysis/calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/manifest/ratings/answers/expectation.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();

fs::path parameters_file(const fs::path& study) {
  std::error_code error;
  return fs::is_directory(study, error) ? study / "metrics" / "parameters.csv" : study;
}

PerceivedParameter perceived(const StimulusParameter& made,
                             const std::map<std::string, double>& by_person) {
  PerceivedParameter seen{.made = made};
  seen.people = static_cast<int>(by_person.size());
  for (const auto& [person, value] : by_person) seen.perceived += value / seen.people;
  double squares = 0.0;
  for (const auto& [person, value] : by_person)
    squares += (value - seen.perceived) * (value - seen.perceived);
  seen.deviation = seen.people < 2 ? unknown_value : std::sqrt(squares / (seen.people - 1));
  return seen;
}

/// Sums of squares and products about the means.
struct Moments {
  double requested = 0.0;  ///< means
  double perceived = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

Moments moments_of(const std::vector<const PerceivedParameter*>& stimuli) {
  Moments m;
  const auto n = static_cast<double>(stimuli.size());
  for (const PerceivedParameter* s : stimuli) {
    m.requested += s->made.requested / n;
    m.perceived += s->perceived / n;
  }
  for (const PerceivedParameter* s : stimuli) {
    const double x = s->made.requested - m.requested;
    const double y = s->perceived - m.perceived;
    m.xx += x * x;
    m.xy += x * y;
    m.yy += y * y;
  }
  return m;
}

Correction correction_of(const std::string& parameter,
                         const std::vector<const PerceivedParameter*>& stimuli) {
  Correction correction{.parameter = parameter, .stimuli = static_cast<int>(stimuli.size())};
  const Moments m = moments_of(stimuli);
  correction.intercept = m.perceived;
  correction.slope_error = correction.r_squared = unknown_value;
  // Shares of a scale; the mean of equal ones may be off by a rounding.
  if (m.xx < 1e-12 * correction.stimuli) return correction;
  correction.slope = m.xy / m.xx;
  correction.intercept = m.perceived - correction.slope * m.requested;
  const double left = std::max(0.0, m.yy - correction.slope * m.xy);
  if (m.yy > 0.0) correction.r_squared = 1.0 - left / m.yy;
  if (correction.stimuli > 2)
    correction.slope_error = std::sqrt(left / (correction.stimuli - 2) / m.xx);
  return correction;
}

constexpr auto calibration_columns = table_of<WithOrigin<PerceivedParameter>>(
    "calibration.csv", "stimulus and parameter",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.of.made.stimulus; }},
     {"parameter", "", "scale or group of scales", [](auto& r) { return r.of.made.parameter; }},
     whose_ratings_column,
     {"requested", "0–1", "requested value", [](auto& r) { return r.of.made.requested; }},
     {"reached", "0–1", "value of the blended motion", [](auto& r) { return r.of.made.reached; }},
     {"perceived", "0–1", "mean of the participants' ratings",
      [](auto& r) { return r.of.perceived; }},
     {"sd", "0–1", "standard deviation of the participants' ratings (n − 1)",
      [](auto& r) { return r.of.deviation; }},
     {"people", "", "number of participants who rated it", [](auto& r) { return r.of.people; }},
     {"next", "0–1",
      "value to request so that the perceived value is the one requested now; empty if the "
      "correction is not usable",
      [](auto& r) { return r.of.next; }}});

constexpr auto corrections_columns = table_of<WithOrigin<Correction>>(
    "corrections.csv", "parameter: perceived = intercept + slope · requested",
    {{"parameter", "", "scale or group of scales", [](auto& r) { return r.of.parameter; }},
     whose_ratings_column,
     {"stimuli", "", "number of stimuli to which the line is fitted",
      [](auto& r) { return r.of.stimuli; }},
     {"intercept", "0–1",
      "perceived value at a requested value of 0; where all requested values are equal, the mean "
      "perceived value",
      [](auto& r) { return r.of.intercept; }},
     {"slope", "", "increase of the perceived value per increase of the requested value",
      [](auto& r) { return r.of.slope; }},
     {"slope_se", "", "its standard error; empty for fewer than three stimuli",
      [](auto& r) { return r.of.slope_error; }},
     {"r_squared", "0–1", "proportion of the variance of perceived values explained",
      [](auto& r) { return r.of.r_squared; }},
     {"usable", "0/1", "1: two or more stimuli and a positive slope",
      [](auto& r) { return r.of.is_usable(); }}});

}  // namespace

std::vector<StimulusParameter> read_stimulus_parameters(const fs::path& study,
                                                        std::vector<Fault>& warnings) {
  if (!fs::exists(study))
    throw Error("there is no study in " + study.string(),
                "name the folder of a finished study, such as out/my-study");
  CsvTable table = read_csv(parameters_file(study));
  if (auto warning = rename_column(table, "asked", "requested"))
    warnings.push_back(*std::move(warning));
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(require_column(table, name));
  };
  const std::size_t requested = column("requested");
  std::vector<StimulusParameter> made;
  for (const auto& row : table.rows) {
    if (row[requested].text.empty()) continue;
    made.push_back({row[column("stimulus")].text, row[column("parameter")].text,
                    number_in(table, row[requested]), number_in(table, row[column("reached")])});
  }
  if (made.empty())
    throw Error(fmt::format("{}: no stimulus has requested parameters", table.file),
                "name the folder of a study whose stimuli have adjectives");
  return made;
}

std::set<std::string> other_stimuli(const fs::path& study,
                                    const std::vector<StimulusParameter>& made) {
  std::set<std::string> others;
  const fs::path all = parameters_file(study).parent_path() / "stimuli.csv";
  const CsvTable table = read_csv(fs::exists(all) ? all : parameters_file(study));
  const auto column = static_cast<std::size_t>(require_column(table, "stimulus"));
  for (const auto& row : table.rows) others.insert(row[column].text);
  for (const StimulusParameter& parameter : made) others.erase(parameter.stimulus);
  return others;
}

std::vector<RatedExample> stimuli_of(const std::vector<StimulusParameter>& made) {
  std::vector<RatedExample> stimuli;
  for (const StimulusParameter& parameter : made)
    if (std::ranges::find(stimuli, parameter.stimulus, &RatedExample::name) == stimuli.end())
      stimuli.push_back({parameter.stimulus, ""});
  return stimuli;
}

Calibration calibrate(const std::vector<StimulusParameter>& made, const Answers& answers,
                      const ScaleSet& scales) {
  Calibration calibration;
  calibration.simulated = answers.simulated;
  for (const StimulusParameter& parameter : made) {
    const auto by_person =
        personal_values(answers, scales, {parameter.stimulus, ""}, parameter.parameter);
    if (!by_person.empty()) calibration.stimuli.push_back(perceived(parameter, by_person));
  }
  if (calibration.stimuli.empty())
    throw Error("the requested parameters of the stimuli were not rated",
                "give answers about these stimuli on the scales of their adjectives, with a column "
                "participant");
  std::map<std::string, std::vector<const PerceivedParameter*>> by_parameter;
  for (const PerceivedParameter& seen : calibration.stimuli)
    by_parameter[seen.made.parameter].push_back(&seen);
  for (const auto& [parameter, stimuli] : by_parameter)
    calibration.corrections.push_back(correction_of(parameter, stimuli));
  for (PerceivedParameter& seen : calibration.stimuli) {
    const auto correction =
        std::ranges::find(calibration.corrections, seen.made.parameter, &Correction::parameter);
    if (correction->is_usable())
      seen.next = std::clamp(correction->request_for(seen.made.requested), 0.0, 1.0);
  }
  return calibration;
}

WrittenTable calibration_table(const Calibration& calibration) {
  return calibration_columns.of_parts(calibration.simulated, calibration.stimuli);
}

WrittenTable corrections_table(const Calibration& calibration) {
  return corrections_columns.of_parts(calibration.simulated, calibration.corrections);
}

}  // namespace mien::pipeline
