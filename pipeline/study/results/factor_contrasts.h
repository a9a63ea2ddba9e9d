#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/noncentral_interval.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

/// Kinds of contrasts. p values are adjusted over the planned contrasts on all scales, and over all
/// pairs of levels of a factor on all scales.
enum class ContrastKind {
  planned,   ///< stated in the manifest (PlannedContrast)
  pairwise,  ///< two levels of a factor
};

inline constexpr Words<ContrastKind> contrast_kind_words = {{"planned", ContrastKind::planned},
                                                            {"pairwise", ContrastKind::pairwise}};

/// A contrast of levels of the design's factors (AnswerSet::factors) on one scale. A participant's
/// score is the weighted sum of the participant's cell means, averaged over the settings in which
/// all compared levels were rated (matched_settings).
struct FactorContrast {
  ContrastKind kind = ContrastKind::planned;
  std::string name;                   ///< of a pair: "sad − happy"
  std::string factors;                ///< "emotion"; several are joined by " × "
  std::string weights;                ///< "sad − 0.5 happy − 0.5 angry"
  std::vector<std::string> settings;  ///< "actor k, action walk"; a single empty one without others
  std::size_t scale = 0;
  int incomplete = 0;  ///< participants who rated some of the cells, but not all: not analysed
  WithinParticipants within;
  EffectInterval dz_ends;  ///< 95 % interval of within.dz
  double paired_adjusted = 1.0;
  double wilcoxon_adjusted = 1.0;
};

/// "actor k, action walk"; empty if there are no other factors.
std::string setting_name(const FactorTable& table, const MatchedSetting& setting);

/// The planned contrasts, then all pairs of levels of each factor, each on its scales. Contrasts
/// with fewer than two complete participants are included without tests if they are planned, and
/// otherwise omitted.
std::vector<FactorContrast> factor_contrasts(const AnswerSet& answer_set);

}  // namespace mien::pipeline
