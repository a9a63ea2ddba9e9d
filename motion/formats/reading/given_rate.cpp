#include "motion/formats/reading/given_rate.h"

#include <cmath>
#include <optional>

#include "motion/text/plain_number.h"

namespace mien::motion {

void note_unused_rate(double used, const ReadOptions& options, std::vector<std::string>& notes) {
  constexpr double tolerance = 0.001;
  const std::optional<double> given = options.frames_per_second;
  if (!given || std::abs(*given / used - 1.0) <= tolerance) return;
  notes.push_back("The file states " + plain_number(used) +
                  " frames per second, which is used instead of the given " + plain_number(*given) +
                  ".");
}

}  // namespace mien::motion
