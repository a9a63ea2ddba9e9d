#include <algorithm>

#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

std::vector<BestSeen> best_seen(const Gathered& gathered,
                                const std::vector<Comparison>& comparisons) {
  std::vector<std::string> settings;
  for (const ReportedStimulus& stimulus : gathered.stimuli)
    if (std::ranges::find(settings, stimulus.setting) == settings.end())
      settings.push_back(stimulus.setting);
  std::vector<BestSeen> all;
  for (const std::string& setting : settings) {
    for (std::size_t scale = 0; scale < gathered.scales.size(); ++scale) {
      for (const bool high : {false, true}) {
        const double sign = high ? 1.0 : -1.0;
        const Comparison* best = nullptr;
        for (const Comparison& c : comparisons) {
          const bool is_here = c.family == ComparisonFamily::best_seen && c.scale == scale &&
                               gathered.stimuli[c.stimulus].setting == setting &&
                               c.within.people >= 2;
          // Of equal ones the first; sums in another order must not decide.
          if (is_here &&
              (best == nullptr || sign * (c.within.t.mean - best->within.t.mean) > 1e-12))
            best = &c;
        }
        if (best == nullptr) continue;
        const Scale& of = gathered.scales[scale];
        all.push_back({setting, high ? of.high : of.low, high, *best,
                       sign * best->within.t.mean > 0.0 && best->paired_adjusted < gathered.alpha});
      }
    }
  }
  return all;
}

}  // namespace mien::pipeline
