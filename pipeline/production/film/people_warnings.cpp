#include "pipeline/production/film/people_warnings.h"

#include <fmt/format.h>

#include "motion/biomechanics/people_contact.h"

namespace mien::pipeline {

std::vector<std::string> people_warnings(const Stimulus& stimulus,
                                         const std::vector<motion::Clip>& clips) {
  constexpr double tolerated_m = 0.03;
  const double fps = stimulus.output.fps;
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    for (std::size_t k = i + 1; k < clips.size(); ++k) {
      for (const motion::PeopleOverlap& one : people_overlaps(clips[i], clips[k], tolerated_m))
        warnings.push_back(fmt::format(
            "\"{}\" and \"{}\" are up to {:.0f} cm deep in each other from {:.2f} to {:.2f} s "
            "({}, {})",
            stimulus.people[i].name, stimulus.people[k].name, 100.0 * one.depth_m, one.first / fps,
            one.last / fps, one.part, one.other));
    }
  }
  return warnings;
}

}  // namespace mien::pipeline
