#include "motion/measures/differences/lint_difference.h"

#include <algorithm>
#include <optional>

namespace mien::motion {

namespace {

/// Frames of a finding as seconds, from its first frame to the one after its last.
bool touch(const Finding& a, double rate_a, const Finding& b, double rate_b) {
  return a.first / rate_a <= (b.last + 1) / rate_b && b.first / rate_b <= (a.last + 1) / rate_a;
}

bool are_one(const Finding& a, double rate_a, const Finding& b, double rate_b) {
  return a.check == b.check && a.joint == b.joint && touch(a, rate_a, b, rate_b);
}

}  // namespace

std::string_view name_of(LintChange::Kind kind) {
  switch (kind) {
    case LintChange::Kind::gone:
      return "gone";
    case LintChange::Kind::worse:
      return "worse";
    case LintChange::Kind::better:
      return "better";
    case LintChange::Kind::appeared:
      break;
  }
  return "new";
}

std::vector<LintChange> lint_changes(const std::vector<Finding>& before, double rate_before,
                                     const std::vector<Finding>& now, double rate_now) {
  using enum LintChange::Kind;
  std::vector<LintChange> changes;
  for (const Finding& finding : now) {
    std::optional<Severity> was;
    for (const Finding& old : before) {
      if (are_one(old, rate_before, finding, rate_now))
        was = std::max(was.value_or(old.severity), old.severity);
    }
    if (!was) {
      changes.push_back({appeared, finding});
    } else if (*was != finding.severity) {
      changes.push_back({finding.severity == Severity::error ? worse : better, finding});
    }
  }
  for (const Finding& old : before) {
    bool is_there = false;
    for (const Finding& finding : now) is_there |= are_one(old, rate_before, finding, rate_now);
    if (!is_there) changes.push_back({gone, old});
  }
  return changes;
}

}  // namespace mien::motion
