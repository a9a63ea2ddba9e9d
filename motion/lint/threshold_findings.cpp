#include "motion/lint/threshold_findings.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

constexpr double bridged_seconds = 0.1;

/// The longest run of values above `level` in [first, last].
int longest_run(std::span<const double> values, int first, int last, double level) {
  int longest = 0;
  int run = 0;
  for (int t = first; t <= last; ++t) {
    run = values[t] > level ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

double worst_of(std::span<const double> values, int first, int last) {
  double worst = -std::numeric_limits<double>::infinity();
  for (int t = first; t <= last; ++t) {
    if (values[t] > worst) worst = values[t];
  }
  return worst;
}

}  // namespace

Finding graded_finding(std::string_view check, double measured, const std::string& unit,
                       const Levels& levels) {
  const bool is_error = measured > levels.error;
  Finding finding;
  finding.check = check;
  finding.measured = measured;
  finding.threshold = is_error ? levels.error : levels.warning;
  finding.unit = unit;
  finding.severity = is_error ? Severity::error : Severity::warning;
  return finding;
}

void add_finding(std::vector<Finding>& findings, const LintMotion& motion, Finding finding) {
  const int start = motion.start;
  const int frames = motion.frames;
  if (!motion.was_loop) {
    findings.push_back(std::move(finding));
    return;
  }
  const bool is_always = finding.first < start && finding.last >= start + frames - 1;
  if (is_always) {
    finding.first = start;
    finding.last = start + frames - 1;
  }
  if (finding.first < start || finding.first >= start + frames) return;
  finding.last = std::min(finding.last, finding.first + frames - 1) - start;
  finding.first -= start;
  findings.push_back(std::move(finding));
}

void add_threshold_findings(std::vector<Finding>& findings, const LintMotion& motion,
                            const MeasuredFault& fault, std::span<const double> values) {
  const int count = static_cast<int>(values.size());
  const int bridged = static_cast<int>(std::lround(bridged_seconds * motion.rate()));
  const int shortest = std::max(
      fault.shortest_frames, static_cast<int>(std::lround(fault.shortest_seconds * motion.rate())));
  for (int first = 0; first < count; ++first) {
    if (!(values[first] > fault.levels.warning)) continue;
    int last = first;
    for (int t = first + 1; t < count && t - last <= bridged + 1; ++t) {
      if (values[t] > fault.levels.warning) last = t;
    }
    if (longest_run(values, first, last, fault.levels.warning) >= shortest) {
      Finding finding;
      finding.check = fault.check;
      finding.joint = fault.joint;
      finding.first = first;
      finding.last = last;
      finding.measured = worst_of(values, first, last);
      const bool is_error = longest_run(values, first, last, fault.levels.error) >= shortest;
      finding.severity = is_error ? Severity::error : Severity::warning;
      finding.threshold = is_error ? fault.levels.error : fault.levels.warning;
      finding.unit = fault.unit;
      finding.sentence = fault.sentence(finding.measured);
      add_finding(findings, motion, std::move(finding));
    }
    first = last;
  }
}

Levels raised_levels(const Levels& levels, std::span<const double> of_original) {
  double most = levels.warning;
  for (const double value : of_original) {
    if (value > most) most = value;
  }
  return {most, most + (levels.error - levels.warning)};
}

std::string rounded(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string display_name(std::string_view joint_name) {
  bool is_of_body = false;
  for (int j = 0; j < body_joint_count; ++j) is_of_body |= name_of(BodyJoint(j)) == joint_name;
  if (!is_of_body) return std::string(joint_name);
  std::string words;
  for (const char letter : joint_name) {
    const bool is_capital = std::isupper(static_cast<unsigned char>(letter)) != 0;
    if (is_capital && !words.empty()) words += ' ';
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return words;
}

}  // namespace mien::motion
