#include "pipeline/study/thresholds/simulated_observer.h"

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

PsychometricFunction simulated_observer(const Manifest& manifest, const TrackProcedure& procedure,
                                        const SimulatedObservers& observers, std::uint64_t seed) {
  constexpr double usual_share = 0.1;  // of the range of levels
  const Questionnaire& asked = questionnaire_of(manifest);
  const double sign = asked.adaptive.easier == LevelDirection::rising ? 1.0 : -1.0;
  const double first = procedure.ease.front(), range = procedure.ease.back() - first;
  PsychometricFunction function{.width = observers.width.value_or(usual_share * range),
                                .guess = asked.trials == &two_interval_form ? 0.5 : observers.guess,
                                .lapse = observers.lapse};
  const double proportion = threshold_proportion(asked.adaptive);
  const double share = (proportion - function.guess) / (1.0 - function.guess - function.lapse);
  if (!(share > 0.0 && share < 1.0))
    throw Error(fmt::format("with a guess rate of {:g} and a lapse rate of {:g}, no level has {:g} "
                            "% positive answers",
                            function.guess, function.lapse, 100.0 * proportion),
                "use smaller rates (--guess, --lapse)");
  const double mean = observers.threshold ? sign * *observers.threshold : first + 0.5 * range;
  const double threshold = mean + observers.threshold_deviation.value_or(usual_share * range) *
                                      normal(seed, "threshold");
  function.location = threshold - function.width * sigmoid_quantile(function.sigmoid, share);
  return function;
}

}  // namespace mien::pipeline
