#include "pipeline/base/documents/p_value.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

constexpr double least_p = 1e-300;
constexpr char below_least[] = "< 1e-300";

}  // namespace

std::string p_of_table(double p) {
  if (std::isnan(p)) return "";
  return p < least_p ? below_least : shortest(p);
}

std::string p_for_people(double p) {
  if (std::isnan(p)) return "–";
  if (p < least_p) return below_least;
  return p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
}

}  // namespace mien::pipeline
