#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/base/statistics/wilcoxon.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Families of comparisons, within which p values are adjusted: comparisons on the scale of the
/// intended emotion and those on other scales separately, those of best_seen together.
enum class ComparisonFamily {
  best_seen,         ///< a video and all videos of the same setting
  modified_acted,    ///< a modified and the acted motion of the same emotion and setting
  modified_neutral,  ///< a modified and the neutral motion of the same setting
  acted_neutral,     ///< an acted and the neutral motion of the same setting
  modified_best,     ///< a modified motion and the unmodified video of its setting rated highest on
                     ///< the emotion
  between_levels,  ///< stimuli that differ in the level of a single factor other than making, such
                   ///< as the actor
};

inline constexpr Words<ComparisonFamily> family_words = {
    {"best-seen", ComparisonFamily::best_seen},
    {"modified-acted", ComparisonFamily::modified_acted},
    {"modified-neutral", ComparisonFamily::modified_neutral},
    {"acted-neutral", ComparisonFamily::acted_neutral},
    {"modified-best", ComparisonFamily::modified_best},
    {"between-levels", ComparisonFamily::between_levels}};

/// The family of a comparison of two stimuli of one setting; nullopt where they are not compared.
std::optional<ComparisonFamily> family_of(const ReportedStimulus& one,
                                          const ReportedStimulus& other);

/// The single factor in whose level two stimuli of the same making, emotion and strength differ;
/// nullopt where they differ in several or one of them lacks it.
std::optional<std::string> differing_factor(const ReportedStimulus& one,
                                            const ReportedStimulus& other);

/// Tests of paired differences, one for each participant.
struct WithinParticipants {
  int people = 0;
  bool all_equal = false;  ///< at least two participants, and all differences are equal
  /// t and p are NaN where all differences are equal, which may be chance with few participants and
  /// points.
  TTest t;
  double dz = 0.0;               ///< Cohen's
  double gz = 0.0;               ///< Hedges'
  Wilcoxon wilcoxon;             ///< exact, conditional on ties; differences of 0 left out
  Wilcoxon pratt;                ///< exact, zeros ranked
  double wilcoxon_normal = 1.0;  ///< p of the normal approximation without correction
  double wilcoxon_normal_corrected = 1.0;  ///< p of the same with continuity correction
  double wilcoxon_zsplit = 1.0;            ///< p of the normal approximation, zeros split
  HodgesLehmann location;
};

WithinParticipants within_participants(const std::vector<double>& differences);

/// Tests of a difference between stimuli on one scale.
struct Comparison {
  ComparisonFamily family = ComparisonFamily::best_seen;
  std::size_t stimulus = 0;
  std::optional<std::size_t> against;  ///< nullopt: all videos of the setting
  std::size_t scale = 0;
  std::string factor;  ///< in between_levels, the factor in which they differ
  /// Whether the stimulus's emotion is an end of this scale: +1 high, −1 low, 0 neither.
  int intended_end = 0;

  int answers = 0;  ///< about the stimulus
  double mean = 0.0;
  int answers_against = 0;
  double mean_against = 0.0;

  /// Welch's test of all answers as if independent. In best_seen it is the test of the emotion
  /// thesis: the video against all videos of the setting, including itself.
  TTest welch;
  double d = 0.0;  ///< Cohen's d_s of the same two samples
  double g = 0.0;  ///< Hedges' g

  /// Tests within participants who saw both. In best_seen the difference is between the video and
  /// the mean of the participant's other videos of the setting.
  WithinParticipants within;

  double welch_adjusted = 1.0;  ///< p adjusted for the number of comparisons of the family
  double paired_adjusted = 1.0;
  double wilcoxon_adjusted = 1.0;
};

/// All comparisons that the stimuli's factors allow, family by family. Those with fewer than two
/// participants or answers are left out.
std::vector<Comparison> compare(const AnswerSet& answer_set);

/// A comparison of two makings over all settings, of ratings towards the intended emotion
/// (positive). Each participant contributes the mean over those settings and emotions of which both
/// sides were rated; cells with one side alone are excluded.
struct OverallComparison {
  ComparisonFamily family = ComparisonFamily::modified_acted;
  std::string emotion;  ///< empty: all
  int matched = 0;      ///< cells (setting and emotion of a participant) with both sides
  int unmatched = 0;    ///< participants who rated both makings, but never in the same cell
  double mean = 0.0;    ///< of the participants' means
  double mean_against = 0.0;
  WithinParticipants within;
  double paired_adjusted = 1.0;  ///< within the family, the row of all emotions by itself
  double wilcoxon_adjusted = 1.0;
};

/// For each family except best_seen: over all emotions, then by emotion.
std::vector<OverallComparison> compare_overall(const AnswerSet& answer_set);

/// +1 where `emotion` is the name of the scale's high end, −1 of its low end, else 0.
int end_sign(const Scale& scale, const std::string& emotion);

/// The p values adjusted for multiple comparisons.
std::vector<double> corrected(const std::vector<double>& p_values, TestCorrection correction);

/// The name of a correction: "Holm".
std::string name_of(TestCorrection correction);

/// The video of a setting with the highest ratings towards an end of a scale.
struct BestSeen {
  std::string setting;
  std::string end;       ///< "sad"
  bool is_high = false;  ///< of its scale
  Comparison comparison;
  bool is_significant =
      false;  ///< significant: towards the end, and the adjusted paired p below alpha
};

/// By setting and end: the video with the largest mean difference towards the end from the
/// participants' other videos.
std::vector<BestSeen> best_seen(const AnswerSet& answer_set,
                                const std::vector<Comparison>& comparisons);

}  // namespace mien::pipeline
