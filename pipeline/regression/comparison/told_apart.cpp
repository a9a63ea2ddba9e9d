#include "pipeline/regression/comparison/told_apart.h"

#include <fmt/format.h>

namespace mien::pipeline {

std::pair<std::string, std::string> told_apart(double before, double now, int digits) {
  constexpr int most_digits = 17;  // those of any two doubles differ
  for (int some = digits;; ++some) {
    std::pair<std::string, std::string> told{fmt::format("{:.{}g}", before, some),
                                             fmt::format("{:.{}g}", now, some)};
    if (some >= most_digits || before == now || told.first != told.second) return told;
  }
}

}  // namespace mien::pipeline
