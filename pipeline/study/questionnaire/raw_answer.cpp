#include "pipeline/study/questionnaire/raw_answer.h"

#include <algorithm>
#include <cmath>

namespace mien::pipeline {

double least_raw(const AnswerSettings& answer) { return answer.slider ? 0.0 : 1.0; }

double most_raw(const AnswerSettings& answer) { return answer.slider ? 100.0 : answer.points; }

double value_of_raw(const Scale& scale, const AnswerSettings& answer, double raw, bool flipped) {
  const double from_left = (raw - least_raw(answer)) / (most_raw(answer) - least_raw(answer));
  const double share = flipped ? 1.0 - from_left : from_left;
  return scale.least + share * (scale.most - scale.least);
}

double raw_of_value(const Scale& scale, const AnswerSettings& answer, double value, bool flipped) {
  const double share = share_of(scale, std::clamp(value, scale.least, scale.most));
  const double from_left = flipped ? 1.0 - share : share;
  return std::round(least_raw(answer) + from_left * (most_raw(answer) - least_raw(answer)));
}

}  // namespace mien::pipeline
