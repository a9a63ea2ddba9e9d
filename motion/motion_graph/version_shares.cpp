#include "motion/motion_graph/version_shares.h"

namespace mien::motion {

std::vector<double> shares_asked(std::span<const MoodFrom> moods, double seconds,
                                 std::size_t versions) {
  std::vector<double> shares(versions, 0.0);
  shares.front() = 1.0;
  for (const MoodFrom& from : moods) {
    if (from.seconds > seconds && &from != &moods.front()) continue;
    double sum = 0.0;
    for (const double weight : from.moods) sum += weight;
    for (std::size_t v = 0; v < versions; ++v) {
      shares[v] = v < from.moods.size() ? from.moods[v] / sum : 0.0;
    }
  }
  return shares;
}

}  // namespace mien::motion
