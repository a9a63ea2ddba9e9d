#include "pipeline/regression/comparison/distinct_numbers.h"

#include <fmt/format.h>

namespace mien::pipeline {

std::pair<std::string, std::string> distinct_numbers(double before, double now, int digits) {
  constexpr int most_digits = 17;  // those of any two doubles differ
  for (int some = digits;; ++some) {
    std::pair<std::string, std::string> texts{fmt::format("{:.{}g}", before, some),
                                              fmt::format("{:.{}g}", now, some)};
    if (some >= most_digits || before == now || texts.first != texts.second) return texts;
  }
}

}  // namespace mien::pipeline
