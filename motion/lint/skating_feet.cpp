#include <algorithm>
#include <cmath>

#include "motion/gait/contact.h"
#include "motion/lint/checks.h"
#include "motion/lint/slip.h"
#include "motion/lint/stretches.h"

namespace mien::motion {

namespace {

constexpr double shortest_slide_seconds = 0.13;
constexpr double beyond_original_metres = 0.012;

double largest_slip(const LintSubject& subject) {
  double largest = 0.0;
  for (const FootPlant& plant : foot_plants(subject.clip)) {
    largest = std::max(largest, planted_slip(subject, plant));
  }
  return largest / subject.scale;
}

/// Captures slide by some centimetres themselves; against an original, what it did not do counts
/// sooner.
Levels slip_levels(const LintOptions& options, const LintSubject* original) {
  if (!original) return options.skate_metres;
  const double before = largest_slip(*original);
  const double warning = std::max(options.skate_metres.warning, before + 0.005);
  return {warning, std::max(warning, before + beyond_original_metres)};
}

/// The part of a plant in which the original's same foot stands too, as far as it does: a slower or
/// smaller step makes feet that are still coming down, or leaving already, look planted.
FootPlant as_in_original(FootPlant plant, const LintSubject& subject,
                         const std::vector<FootPlant>& of_original, const LintSubject& original) {
  const double rate = static_cast<double>(subject.frame_count()) / original.frame_count();
  const int cycle = subject.clip.loops ? subject.frame_count() : 0;
  FootPlant best = plant;
  int most = 0;
  for (const FootPlant& other : of_original) {
    if (other.left != plant.left) continue;
    for (const int shift : {-cycle, 0, cycle}) {
      const int first =
          std::max(plant.first, static_cast<int>(std::ceil(other.first * rate)) + shift);
      const int last =
          std::min(plant.last, static_cast<int>(std::floor(other.last * rate)) + shift);
      if (last - first < most) continue;
      most = last - first + 1;
      best = {plant.left, first, last};
    }
  }
  return best;
}

/// The plants whose slip counts.
std::vector<FootPlant> judged_plants(const LintSubject& subject, const LintSubject* original) {
  std::vector<FootPlant> plants = foot_plants(subject.clip);
  if (!original) return plants;
  const std::vector<FootPlant> of_original = foot_plants(original->clip);
  for (FootPlant& plant : plants) plant = as_in_original(plant, subject, of_original, *original);
  return plants;
}

std::string sentence_of(const FootPlant& plant, double slip) {
  return std::string("The planted ") + (plant.left ? "left" : "right") + " foot slides by " +
         rounded(100.0 * slip, 1) + " cm.";
}

void find_slips(const LintSubject& subject, const LintOptions& options, const LintSubject* original,
                Findings& findings) {
  const Levels levels = slip_levels(options, original);
  for (const FootPlant& plant : judged_plants(subject, original)) {
    const double slip = planted_slip(subject, plant) / subject.scale;
    if (!(slip > levels.warning)) continue;
    const bool is_error = slip > levels.error;
    Finding finding;
    finding.check = "foot-skate";
    finding.joint = name_of(plant.left ? LeftAnkle : RightAnkle);
    finding.first = plant.first;
    finding.last = plant.last;
    finding.measured = slip;
    finding.threshold = is_error ? levels.error : levels.warning;
    finding.unit = "m";
    finding.severity = is_error ? Severity::error : Severity::warning;
    finding.sentence = sentence_of(plant, slip);
    add_finding(findings, subject, std::move(finding));
  }
}

/// Speeds where neither foot is planted.
std::vector<double> unplanted_speeds(const LintSubject& subject) {
  std::vector<double> speeds = support_speeds(subject);
  for (const FootPlant& plant : foot_plants(subject.clip)) {
    const int last = std::min(plant.last, subject.frame_count() - 1);
    for (int t = plant.first; t <= last; ++t) speeds[t] = nothing;
  }
  return speeds;
}

}  // namespace

Findings find_skating_feet(const LintSubject& subject, const LintOptions& options,
                           const LintSubject* original) {
  Findings findings;
  find_slips(subject, options, original, findings);
  const auto sentence = [](double worst) {
    return "No foot stands still: whatever touches the floor slides at up to " + rounded(worst, 1) +
           " m/s.";
  };
  const Levels levels =
      raised(options.slide_speed, original ? unplanted_speeds(*original) : std::vector<double>());
  add_stretches(findings, subject,
                {"foot-skate", "", "m/s", levels, shortest_slide_seconds, 3, sentence},
                unplanted_speeds(subject));
  return findings;
}

}  // namespace mien::motion
