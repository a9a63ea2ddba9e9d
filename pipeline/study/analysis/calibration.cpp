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

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

fs::path parameters_file(const fs::path& study) {
  std::error_code error;
  return fs::is_directory(study, error) ? study / "metrics" / "parameters.csv" : study;
}

PerceivedParameter perceived(const MadeParameter& made,
                             const std::map<std::string, double>& by_person) {
  PerceivedParameter seen{.made = made};
  seen.people = static_cast<int>(by_person.size());
  for (const auto& [person, value] : by_person) seen.perceived += value / seen.people;
  double squares = 0.0;
  for (const auto& [person, value] : by_person)
    squares += (value - seen.perceived) * (value - seen.perceived);
  seen.deviation = seen.people < 2 ? not_known : std::sqrt(squares / (seen.people - 1));
  return seen;
}

/// Sums of squares and products about the means.
struct Moments {
  double asked = 0.0;  ///< means
  double perceived = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

Moments moments_of(const std::vector<const PerceivedParameter*>& stimuli) {
  Moments m;
  const auto n = static_cast<double>(stimuli.size());
  for (const PerceivedParameter* s : stimuli) {
    m.asked += s->made.asked / n;
    m.perceived += s->perceived / n;
  }
  for (const PerceivedParameter* s : stimuli) {
    const double x = s->made.asked - m.asked;
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
  correction.slope_error = correction.r_squared = not_known;
  // Shares of a scale; the mean of equal ones may be off by a rounding.
  if (m.xx < 1e-12 * correction.stimuli) return correction;
  correction.slope = m.xy / m.xx;
  correction.intercept = m.perceived - correction.slope * m.asked;
  const double left = std::max(0.0, m.yy - correction.slope * m.xy);
  if (m.yy > 0.0) correction.r_squared = 1.0 - left / m.yy;
  if (correction.stimuli > 2)
    correction.slope_error = std::sqrt(left / (correction.stimuli - 2) / m.xx);
  return correction;
}

constexpr auto calibration_columns = table_of<GivenOrSimulated<PerceivedParameter>>(
    "calibration.csv", "stimulus and parameter",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.of.made.stimulus; }},
     {"parameter", "", "scale or group of scales", [](auto& r) { return r.of.made.parameter; }},
     whose_ratings_column,
     {"asked", "0–1", "what the stimulus asks for", [](auto& r) { return r.of.made.asked; }},
     {"reached", "0–1", "what the blend has", [](auto& r) { return r.of.made.reached; }},
     {"perceived", "0–1", "mean over people of their answers",
      [](auto& r) { return r.of.perceived; }},
     {"sd", "0–1", "standard deviation of it, n − 1", [](auto& r) { return r.of.deviation; }},
     {"people", "", "who answered", [](auto& r) { return r.of.people; }},
     {"next", "0–1", "value to request so that the present target is perceived",
      [](auto& r) { return r.of.next; }}});

constexpr auto corrections_columns = table_of<GivenOrSimulated<Correction>>(
    "corrections.csv", "parameter: perceived = intercept + slope · asked",
    {{"parameter", "", "scale or group of scales", [](auto& r) { return r.of.parameter; }},
     whose_ratings_column,
     {"stimuli", "", "stimuli that it is fitted to", [](auto& r) { return r.of.stimuli; }},
     {"intercept", "0–1", "perceived value where 0 is requested",
      [](auto& r) { return r.of.intercept; }},
     {"slope", "", "growth of perceived by asked", [](auto& r) { return r.of.slope; }},
     {"slope_se", "", "its standard error", [](auto& r) { return r.of.slope_error; }},
     {"r_squared", "0–1", "share of the variance explained",
      [](auto& r) { return r.of.r_squared; }},
     {"usable", "0/1", "1: perceived values increase with requested ones",
      [](auto& r) { return r.of.is_usable(); }}});

}  // namespace

std::vector<MadeParameter> read_made_parameters(const fs::path& study) {
  if (!fs::exists(study))
    throw Error("there is no study in " + study.string(),
                "name the folder of a finished study, such as out/my-study");
  const CsvTable table = read_csv(parameters_file(study));
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(require_column(table, name));
  };
  const std::size_t asked = column("asked");
  std::vector<MadeParameter> made;
  for (const auto& row : table.rows) {
    if (row[asked].text.empty()) continue;
    made.push_back({row[column("stimulus")].text, row[column("parameter")].text,
                    number_in(table, row[asked]), number_in(table, row[column("reached")])});
  }
  if (made.empty())
    throw Error(fmt::format("{}: no stimulus has requested parameters", table.file),
                "name the folder of a study whose stimuli have adjectives");
  return made;
}

std::set<std::string> other_stimuli(const fs::path& study, const std::vector<MadeParameter>& made) {
  std::set<std::string> others;
  const fs::path all = parameters_file(study).parent_path() / "stimuli.csv";
  const CsvTable table = read_csv(fs::exists(all) ? all : parameters_file(study));
  const auto column = static_cast<std::size_t>(require_column(table, "stimulus"));
  for (const auto& row : table.rows) others.insert(row[column].text);
  for (const MadeParameter& parameter : made) others.erase(parameter.stimulus);
  return others;
}

std::vector<RatedExample> stimuli_of(const std::vector<MadeParameter>& made) {
  std::vector<RatedExample> stimuli;
  for (const MadeParameter& parameter : made)
    if (std::ranges::find(stimuli, parameter.stimulus, &RatedExample::name) == stimuli.end())
      stimuli.push_back({parameter.stimulus, ""});
  return stimuli;
}

Calibration calibrate(const std::vector<MadeParameter>& made, const Answers& answers,
                      const ScaleSet& scales) {
  Calibration calibration;
  calibration.simulated = answers.simulated;
  for (const MadeParameter& parameter : made) {
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
      seen.next = std::clamp(correction->ask_for(seen.made.asked), 0.0, 1.0);
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
