#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/analysis_of_variance.h"
#include "pipeline/manifest/factor_crossing.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

/// A main effect or an interaction of the design's factors on one scale.
struct FactorEffect {
  std::string name;  ///< "actor × emotion"
  VarianceEffect test;
  double adjusted = 1.0;  ///< p_corrected adjusted over all effects on all scales
};

/// Mean rating of a cell (a combination of levels) over the participants of the analysis.
struct FactorCell {
  std::string group;     ///< empty without groups
  std::size_t cell = 0;  ///< index into Crossing::cells
  int people = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of participants' means (n − 1)
  /// Half width of the 95 % interval for comparisons within participants
  /// (within_participant_margins), computed within the group. NaN for a single participant.
  double margin = 0.0;
};

/// The analysis of variance of one scale. A participant's rating of a cell is the mean of the
/// participant's ratings of its stimuli.
struct ScaleEffects {
  std::size_t scale = 0;
  int people = 0;      ///< participants who rated every cell
  int incomplete = 0;  ///< participants who rated some cells, but not all: not analysed
  int ungrouped = 0;   ///< participants who rated every cell, but are in no group: not analysed
  std::vector<std::string> groups;    ///< answers that form groups; empty without groups
  std::vector<FactorEffect> effects;  ///< empty with fewer than two participants (in each group)
  std::vector<FactorCell> cells;      ///< by group; empty if `effects` is
};

/// The effects of the design's factors (AnswerSet::factors) within participants, and of groups.
struct FactorEffects {
  Crossing crossing;                 ///< the part of the design that is analysed
  std::string between;               ///< question whose answers form groups; or empty
  std::vector<ScaleEffects> scales;  ///< of each scale; empty without a crossing
  std::string reason;                ///< sentence on why there is no analysis of variance; or empty
};

FactorEffects factor_effects(const AnswerSet& answer_set, const ParticipantTable& participants);

/// "actor × emotion", "gender × actor": the name of an effect. `factors` are the names of the
/// crossing's factors, `between` is that of the question that forms groups.
std::string effect_name(const VarianceTerm& effect, const std::vector<std::string>& factors,
                        const std::string& between);

/// "emotion sad, actor k": the levels of a cell of the crossing.
std::string cell_name(const FactorTable& table, const Crossing& crossing, std::size_t cell);

/// Names of the crossing's factors.
std::vector<std::string> factor_names(const FactorTable& table, const Crossing& crossing);

/// Sentences on the part of the design that is analysed: the levels of each factor, the level of
/// factors that are not crossed, and the rated stimuli that are left out. Empty without a crossing.
std::vector<std::string> crossing_sentences(const AnswerSet& answer_set, const Crossing& crossing);

}  // namespace mien::pipeline
