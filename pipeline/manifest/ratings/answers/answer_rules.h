#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// What to do about answers that are not as a study wants them. Whatever is chosen is reported.
struct AnswerRules {
  enum class Repeated { refuse, first, last, mean };  ///< by `order` where given, else by line
  enum class Unknown { refuse, ignore };              ///< scales and stimuli
  enum class Constant { keep, drop };  ///< participants who answer the same to everything
  enum class Missing { ignore, refuse };

  Repeated repeated = Repeated::refuse;
  Unknown unknown = Unknown::refuse;
  Constant constant = Constant::keep;
  Missing missing = Missing::ignore;

  /// For a manifest's ratings: only participant, stimulus, scale and value are read; remedies
  /// name keys of a manifest instead of options of `mien study analyze`.
  bool plain = false;

  /// Stimuli that are known though no examples: answers about them are passed over.
  std::set<std::string> left_out = {};
};

/// One answer and where it was read.
struct StudyAnswer {
  std::string participant;  ///< empty: a mean of several people's answers
  std::string stimulus;     ///< name of the example
  std::string scale;        ///< id
  double value = 0.0;       ///< in the scale's own range
  Place place;              ///< of the value; of plain answers, of the stimulus
  std::optional<double> rt_ms;
  std::optional<double> order;  ///< at which turn the participant answered
  std::string comment;
};

/// Something that a reader of the results should know.
struct StudyWarning {
  std::string kind;  ///< "missing", "repeated", "unknown-scale", "constant-participant", …
  Place place;       ///< where it shows first; empty for the study as a whole
  std::string text;  ///< a plain sentence
};

/// The answers of a study about its examples, after the rules.
struct StudyAnswers {
  std::vector<StudyAnswer> answers;  ///< in the order of the file; at most one of a kind
  std::vector<StudyWarning> warnings;
  bool simulated = false;

  /// For impressions_of.
  Answers plain() const;
};

/// Takes one of repeated answers, or their mean, in the place of the first.
void settle_repeated(StudyAnswers& study, const AnswerRules& rules, std::vector<Fault>& faults);

/// Tells participants with at least three answers, all at the same place of their scales.
void settle_constant(StudyAnswers& study, const ScaleSet& scales, AnswerRules::Constant rule);

/// Tells what was not answered: `left_empty`, the scales that a participant left out about a
/// stimulus that he saw, and, when at least half of the participants saw every stimulus, the
/// stimuli that he did not see.
void settle_missing(StudyAnswers& study, const std::vector<StudyAnswer>& left_empty,
                    AnswerRules::Missing rule, std::vector<Fault>& faults);

}  // namespace mien::pipeline
