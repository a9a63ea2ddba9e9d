#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The treatment of answers that do not conform to the study's plan. Every treatment is reported.
struct AnswerRules {
  /// `first` and `last` refer to the answers' `order` or, where it is absent or equal, to their
  /// line.
  enum class Repeated { refuse, first, last, mean };
  enum class Unknown { refuse, ignore };  ///< unknown scales and stimuli
  enum class Constant { keep, drop };     ///< participants who give the same answer throughout
  enum class Missing { ignore, refuse };

  Repeated repeated = Repeated::refuse;
  Unknown unknown = Unknown::refuse;
  Constant constant = Constant::keep;
  Missing missing = Missing::ignore;

  /// For a manifest's ratings: only participant, stimulus, scale, value and simulated are read, and
  /// suggested remedies name manifest keys instead of options of `mien study analyze`.
  bool plain = false;

  /// Known stimuli that are not examples; answers about them are ignored.
  std::set<std::string> left_out = {};
};

/// One answer and its position in the source file.
struct StudyAnswer {
  std::string participant;  ///< empty: a mean over several participants
  std::string stimulus;     ///< name of the example; as written if any stimulus is accepted
  std::string scale;        ///< id
  double value = 0.0;       ///< value in the scale's range
  Place place;              ///< position of the value, or of the stimulus for plain answers
  std::optional<double> rt_ms;
  std::optional<double> order;  ///< position of the answer in the participant's sequence
  std::string comment;
};

/// A warning for readers of the results.
struct StudyWarning {
  std::string kind;  ///< "missing", "repeated", "unknown-scale", "constant-participant", …
  Place place;       ///< first occurrence; empty for the study as a whole
  std::string text;  ///< a plain sentence
};

/// The answers of a study about its examples, after the rules have been applied.
struct StudyAnswers {
  /// In file order; at most one per participant, stimulus and scale.
  std::vector<StudyAnswer> answers;
  std::vector<StudyWarning> warnings;
  bool simulated = false;

  /// Returns the answers in the form that impressions_of takes.
  Answers plain() const;
};

/// Replaces repeated answers by one of them or by their mean, at the position of the first, and
/// adds a warning for each further answer, or a fault if the rules refuse them.
void settle_repeated(StudyAnswers& study, const AnswerRules& rules, std::vector<Fault>& faults);

/// Reports participants with at least three answers, all at the same position on their scales, and
/// drops them if `rule` says so.
void settle_constant(StudyAnswers& study, const ScaleSet& scales, AnswerRules::Constant rule);

/// Reports missing answers: those in `left_empty`, the scales that a participant skipped for a
/// stimulus that they saw, and, if at least half of the participants saw every stimulus, the
/// stimuli that a participant did not see.
void settle_missing(StudyAnswers& study, const std::vector<StudyAnswer>& left_empty,
                    AnswerRules::Missing rule, std::vector<Fault>& faults);

}  // namespace mien::pipeline
