#include "motion/lint/finding.h"

#include <algorithm>

namespace mien::motion {

std::string_view name_of(Severity severity) {
  return severity == Severity::error ? "error" : "warning";
}

bool has_errors(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::error; });
}

}  // namespace mien::motion
