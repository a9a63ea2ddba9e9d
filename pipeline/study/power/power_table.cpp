#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "pipeline/study/power/power_output.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

using Row = PlannedTestPower;

constexpr Table power_form = table_of<Row>(
    "power.csv", "planned test in a study of one size",
    {{"kind", "", "effect (of the analysis of variance) or contrast (planned)",
      [](auto& r) { return r.is_contrast ? "contrast" : "effect"; }},
     {"test", "", "name of the effect or contrast", [](auto& r) { return r.name; }},
     {"scale", "", "scale id", [](auto& r) { return r.scale; }},
     {"random", "",
      "random effects of the test: participants (as in the report) or participants-and-stimuli "
      "(mixed model)",
      [](auto& r) { return word_of(tested_by_words, r.by); }},
     {"participants", "", "number of participants", [](auto& r) { return r.participants; }},
     {"stimuli_per_cell", "",
      "number of stimuli in each combination of levels of the analysed factors; empty if it "
      "differs",
      [](auto& r) {
        return r.stimuli_per_cell == 0 ? std::string() : std::to_string(r.stimuli_per_cell);
      }},
     {"complete_people", "", "mean number of participants who rated every cell",
      [](auto& r) { return r.people; }},
     {"assumed", "points",
      "assumed size of the effect; empty for effects that follow from stated true ratings",
      [](auto& r) { return r.assumed; }},
     {"studies", "", "number of simulated studies in which the test was possible",
      [](auto& r) { return r.studies; }},
     {"power", "0–1",
      "proportion of studies in which the test is significant, corrected for multiple comparisons",
      [](auto& r) { return r.power.share; }},
     {"power_se", "0–1", "Monte-Carlo standard error of power",
      [](auto& r) { return r.power_error; }},
     {"power_low", "0–1", "lower end of the 95 % Monte-Carlo interval of power (Wilson)",
      [](auto& r) { return r.power.low; }},
     {"power_high", "0–1", "upper end of the 95 % Monte-Carlo interval of power (Wilson)",
      [](auto& r) { return r.power.high; }},
     {"false_positives", "0–1",
      "proportion of studies without any effect in which the test, not corrected, is significant",
      [](auto& r) { return r.false_positives.share; }},
     {"false_positives_low", "0–1", "lower end of its 95 % Monte-Carlo interval (Wilson)",
      [](auto& r) { return r.false_positives.low; }},
     {"false_positives_high", "0–1", "upper end of its 95 % Monte-Carlo interval (Wilson)",
      [](auto& r) { return r.false_positives.high; }},
     {"simulated", "", "always 1: no answers of participants", [](auto&) { return 1; }}});

bool is_same_test(const Row& one, const Row& other) {
  return std::tie(one.is_contrast, one.name, one.scale, one.by, one.stimuli_per_cell) ==
         std::tie(other.is_contrast, other.name, other.scale, other.by, other.stimuli_per_cell);
}

/// "76.7 [71.9, 81.0] (false positives 54.7)"
std::string power_text(const Row& row) {
  if (row.studies == 0) return "not possible, because too few participants rate every cell";
  return fmt::format("{:.1f} [{:.1f}, {:.1f}] (false positives {:.1f})", 100.0 * row.power.share,
                     100.0 * row.power.low, 100.0 * row.power.high,
                     100.0 * row.false_positives.share);
}

/// More than α by more than the error of the simulation.
bool has_false_positives(const Row& row, double alpha) {
  return row.studies > 0 && row.false_positives.low > 1.2 * alpha;
}

/// The smallest of the simulated numbers of participants with the intended power, and where a test
/// is not valid.
std::string needed_text(const std::vector<Row>& rows, const Row& row, double wanted_power,
                        double alpha) {
  if (has_false_positives(row, alpha))
    return row.by == TestedBy::participants ? "valid for these stimuli only" : "not valid";
  const Row* least = nullptr;
  int most = 0;
  for (const Row& other : rows) {
    if (!is_same_test(row, other)) continue;
    most = std::max(most, other.participants);
    if (other.power.share >= wanted_power &&
        (least == nullptr || other.participants < least->participants))
      least = &other;
  }
  if (least != nullptr)
    return fmt::format("{:g} % from {} participants", 100.0 * wanted_power, least->participants);
  return fmt::format("below {:g} % up to {} participants", 100.0 * wanted_power, most);
}

}  // namespace

WrittenTable power_table(const std::vector<Row>& rows) { return power_form.of(rows); }

std::vector<std::string> planned_power_lines(const std::vector<Row>& rows, int participants,
                                             double wanted_power, double alpha) {
  std::vector<std::string> lines;
  const Row* before = nullptr;
  for (const Row& row : rows) {
    if (row.participants != participants) continue;
    const bool is_new = before == nullptr || before->is_contrast != row.is_contrast ||
                        before->name != row.name || before->scale != row.scale;
    if (is_new)
      lines.push_back(fmt::format("{} ({}, {})", row.name,
                                  row.is_contrast ? "planned contrast" : "effect", row.scale));
    before = &row;
    std::string line = "  ";
    if (row.stimuli_per_cell > 0)
      line += fmt::format(
          "{} per cell, ",
          counted_noun(static_cast<std::size_t>(row.stimuli_per_cell), "stimulus", "stimuli"));
    line += row.by == TestedBy::participants ? "participants random: "
                                             : "participants and stimuli random: ";
    line += power_text(row);
    if (row.studies > 0) line += "; " + needed_text(rows, row, wanted_power, alpha);
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> planned_power_notes(const std::vector<Row>& rows, int participants,
                                             double alpha) {
  std::vector<std::string> notes = {"In brackets: 95 % interval of the simulation (Wilson)."};
  notes.push_back(fmt::format(
      "False positives: percent of simulated studies without any effect in which the test is "
      "significant by itself, with α = {:g} and not corrected for multiple comparisons.",
      alpha));
  const auto any_by = [&](TestedBy by) {
    return std::ranges::any_of(rows, [&](const Row& row) {
      return row.participants == participants && row.by == by && has_false_positives(row, alpha);
    });
  };
  if (any_by(TestedBy::participants))
    notes.emplace_back(
        "“Valid for these stimuli only”: the test does not control for stimuli. It takes "
        "differences between these particular stimuli for effects, and more often so with more "
        "participants; hence no number of participants is given. Use more stimuli per cell and the "
        "test with participants and stimuli random, or estimate power for these particular stimuli "
        "(--spread with 0 for stimuli).");
  if (any_by(TestedBy::participants_and_stimuli))
    notes.emplace_back(
        "“Not valid”: the test has more false positives than α even with stimuli random; hence no "
        "number of participants is given. Use more stimuli per cell.");
  return notes;
}

}  // namespace mien::pipeline
