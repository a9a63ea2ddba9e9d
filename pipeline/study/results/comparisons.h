#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/base/statistics/wilcoxon.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Families of comparisons, within which p values are adjusted. In each family except best_seen,
/// comparisons on the scale of the intended emotion are adjusted separately from those on other
/// scales.
enum class ComparisonFamily {
  best_seen,         ///< a video and all other videos of the same setting
  modified_acted,    ///< a modified and the acted motion of the same emotion and setting
  modified_neutral,  ///< a modified and the neutral motion of the same setting
  acted_neutral,     ///< an acted and the neutral motion of the same setting
  /// A modified motion and, of the unmodified ones of the same setting, that with the highest mean
  /// rating towards the modified motion's emotion; only on that emotion's scale.
  modified_best,
  between_levels,  ///< stimuli that differ only in the level of one factor, such as the actor
                   ///< (differing_factor)
};

inline constexpr Words<ComparisonFamily> family_words = {
    {"best-seen", ComparisonFamily::best_seen},
    {"modified-acted", ComparisonFamily::modified_acted},
    {"modified-neutral", ComparisonFamily::modified_neutral},
    {"acted-neutral", ComparisonFamily::acted_neutral},
    {"modified-best", ComparisonFamily::modified_best},
    {"between-levels", ComparisonFamily::between_levels}};

/// The family of the comparison of `one` with `other`: modified_acted, modified_neutral or
/// acted_neutral; nullopt if none of these compares them.
std::optional<ComparisonFamily> family_of(const ReportedStimulus& one,
                                          const ReportedStimulus& other);

/// The only factor in whose level two stimuli differ, if it is not `made`, `emotion` or `strength`.
/// Nullopt otherwise, or if the stimuli do not have the same factors. `example` and `clip` are
/// ignored.
std::optional<std::string> differing_factor(const ReportedStimulus& one,
                                            const ReportedStimulus& other);

/// Tests of paired differences, one difference per participant.
struct WithinParticipants {
  int people = 0;
  bool all_equal = false;  ///< at least two participants, and all differences are equal
  /// t, p, dz and gz are NaN if all differences are equal (or there is only one), which may occur
  /// by chance with few participants and few points of a scale.
  TTest t;
  double dz = 0.0;               ///< Cohen's d_z
  double gz = 0.0;               ///< Hedges' g_z
  Wilcoxon wilcoxon;             ///< exact, conditional on ties; zero differences omitted
  Wilcoxon pratt;                ///< exact, zero differences ranked (Pratt)
  double wilcoxon_normal = 1.0;  ///< p by normal approximation without continuity correction
  double wilcoxon_normal_corrected = 1.0;  ///< p by normal approximation with continuity correction
  double wilcoxon_zsplit = 1.0;  ///< p by normal approximation, zeros split between the signs
  HodgesLehmann location;
};

WithinParticipants within_participants(const std::vector<double>& differences);

/// Tests of a difference between stimuli on one scale. Means are in scale units.
struct Comparison {
  ComparisonFamily family = ComparisonFamily::best_seen;
  std::size_t stimulus = 0;
  std::optional<std::size_t> against;  ///< other stimulus; nullopt: all videos of the setting
  std::size_t scale = 0;
  std::string factor;  ///< in between_levels, the factor in which the stimuli differ
  /// The end of this scale that is the stimulus's emotion: +1 high, −1 low, 0 neither.
  int intended_end = 0;

  int answers = 0;  ///< number of answers about the stimulus
  double mean = 0.0;
  int answers_against = 0;
  double mean_against = 0.0;

  /// Welch's test of all answers as if they were independent. In best_seen, as in the emotion
  /// thesis, the video is compared with all videos of the setting including itself.
  TTest welch;
  /// Cohen's d_s of the same two samples; NaN, as t and p, if neither sample varies.
  double d = 0.0;
  double g = 0.0;  ///< Hedges' g

  /// Tests within participants who saw both. In best_seen, the difference is between the video and
  /// the mean of the other videos of the setting that the participant saw.
  WithinParticipants within;

  // p values adjusted within the family as ComparisonFamily describes.
  double welch_adjusted = 1.0;
  double paired_adjusted = 1.0;
  double wilcoxon_adjusted = 1.0;
};

/// All comparisons that the stimuli's factors allow, sorted by family. Comparisons with fewer than
/// two answers about either stimulus are omitted.
std::vector<Comparison> compare(const AnswerSet& answer_set);

/// A comparison of two kinds of motions (modified, acted or neutral) over all settings, on the
/// scales of the intended emotions, by ratings in scale units from the middle of the scale,
/// counted positive towards the intended emotion. A cell is a setting together with an emotion and
/// a scale. Each participant contributes the mean over the cells in which they rated motions of
/// both kinds; other cells are excluded.
struct OverallComparison {
  ComparisonFamily family = ComparisonFamily::modified_acted;
  std::string emotion;  ///< empty: all emotions
  int matched = 0;      ///< cells with both kinds rated, summed over participants
  int unmatched = 0;    ///< number of participants who rated both kinds, but never in the same cell
  double mean = 0.0;    ///< mean of the participants' means
  double mean_against = 0.0;
  WithinParticipants within;
  double paired_adjusted = 1.0;  ///< p adjusted over the single emotions of the family; not
                                 ///< adjusted if `emotion` is empty
  double wilcoxon_adjusted = 1.0;
};

/// Overall comparisons of modified_acted, modified_neutral and acted_neutral with at least two
/// participants: for each family over all emotions, then by emotion.
std::vector<OverallComparison> compare_overall(const AnswerSet& answer_set);

/// +1 if `emotion` is the name of the scale's high end, −1 if it is that of the low end, otherwise
/// 0.
int end_sign(const Scale& scale, const std::string& emotion);

/// The p values adjusted for multiple comparisons.
std::vector<double> corrected(const std::vector<double>& p_values, TestCorrection correction);

/// The name of a correction: "Holm".
std::string name_of(TestCorrection correction);

/// The video of a setting with the highest ratings towards one end of a scale.
struct BestSeen {
  std::string setting;
  std::string end;       ///< "sad"
  bool is_high = false;  ///< whether it is the high end of its scale
  Comparison comparison;
  bool is_significant =
      false;  ///< the difference is towards the end, and paired_adjusted is below alpha
};

/// For each setting and end, the video whose ratings differ most towards the end, on average over
/// at least two participants, from the other videos of the setting.
std::vector<BestSeen> best_seen(const AnswerSet& answer_set,
                                const std::vector<Comparison>& comparisons);

}  // namespace mien::pipeline
