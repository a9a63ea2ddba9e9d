#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/base/statistics/wilcoxon.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// What is compared with what; p values are corrected within a family: comparisons on the scale of
/// the emotion that was meant by themselves, those on other scales by themselves, and those of
/// best_seen all together.
enum class ComparisonFamily {
  best_seen,         ///< a video with the videos of the same setting
  modified_acted,    ///< a modified motion with the acted one of the same emotion and setting
  modified_neutral,  ///< a modified motion with the neutral one of its setting
  acted_neutral,     ///< an acted motion with it
  modified_best,   ///< a modified motion with the video of its setting, itself no modified one, in
                   ///< which the emotion is seen most
  between_levels,  ///< what differs in the level of one factor alone, not in making: two actors
};

inline constexpr Words<ComparisonFamily> family_words = {
    {"best-seen", ComparisonFamily::best_seen},
    {"modified-acted", ComparisonFamily::modified_acted},
    {"modified-neutral", ComparisonFamily::modified_neutral},
    {"acted-neutral", ComparisonFamily::acted_neutral},
    {"modified-best", ComparisonFamily::modified_best},
    {"between-levels", ComparisonFamily::between_levels}};

/// How two stimuli of one setting are compared, if at all.
std::optional<ComparisonFamily> family_of(const ReportedStimulus& one,
                                          const ReportedStimulus& other);

/// The factor in whose level alone two stimuli of one making, emotion and strength differ; none
/// where they differ in several, or in what only one of them has.
std::optional<std::string> differing_factor(const ReportedStimulus& one,
                                            const ReportedStimulus& other);

/// Tests of paired differences, each a person's.
struct WithinPersons {
  int people = 0;
  bool all_alike = false;  ///< the differences of two people or more are all the same
  /// t and p are NaN where all differences are alike: few people on few points say the same by
  /// chance.
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

WithinPersons within_persons(const std::vector<double>& differences);

/// Tests of one difference on one scale.
struct Comparison {
  ComparisonFamily family = ComparisonFamily::best_seen;
  std::size_t stimulus = 0;
  std::optional<std::size_t> against;  ///< none: the videos of the setting
  std::size_t scale = 0;
  std::string factor;  ///< of between_levels: the one in which they differ
  /// Which end the emotion of the stimulus is of this scale: +1 high, −1 low, 0 neither.
  int own_end = 0;

  int answers = 0;  ///< about the stimulus
  double mean = 0.0;
  int answers_against = 0;
  double mean_against = 0.0;

  /// Welch's test of all answers as if they were independent. Of best_seen it is the thesis' test:
  /// the video against all videos of the setting, itself among them.
  TTest welch;
  double d = 0.0;  ///< Cohen's d_s of the same two samples
  double g = 0.0;  ///< Hedges' g

  /// Within persons: of each who saw both, the difference; of best_seen that between the video and
  /// the mean of the person's other videos of the setting.
  WithinPersons within;

  double welch_adjusted = 1.0;  ///< p corrected for the number of comparisons of the family
  double paired_adjusted = 1.0;
  double wilcoxon_adjusted = 1.0;
};

/// All comparisons that the stimuli's factors make possible, family by family. Those without two
/// persons or answers are left out.
std::vector<Comparison> compare(const Gathered& gathered);

/// How far stimuli of one making are seen towards the emotion that was meant, against those of
/// another making, over all settings, like with like: of each person the mean over those settings
/// and emotions of which the person judged both sides, turned so that the emotion is positive. What
/// somebody saw one side of alone counts in neither.
struct OverallComparison {
  ComparisonFamily family = ComparisonFamily::modified_acted;
  std::string emotion;  ///< empty: all
  int matched = 0;      ///< settings and emotions of all people, both sides seen
  int unmatched = 0;    ///< people who judged both sides, but never of one setting and emotion
  double mean = 0.0;    ///< of the people's means
  double mean_against = 0.0;
  WithinPersons within;
  double paired_adjusted = 1.0;  ///< within the family, the row of all emotions by itself
  double wilcoxon_adjusted = 1.0;
};

/// Of each family but best_seen: over all emotions, then emotion by emotion.
std::vector<OverallComparison> compare_overall(const Gathered& gathered);

/// +1 where `emotion` is the name of the scale's high end, −1 of its low end, else 0.
int end_of(const Scale& scale, const std::string& emotion);

/// The p values after the correction.
std::vector<double> corrected(const std::vector<double>& p_values, TestCorrection correction);

/// Its name in plain words: "Holm".
std::string name_of(TestCorrection correction);

/// The video in which an end of a scale is seen most, among those of a setting.
struct BestSeen {
  std::string setting;
  std::string end;       ///< "sad"
  bool is_high = false;  ///< of its scale
  Comparison comparison;
  bool is_found = false;  ///< towards the end, and its paired test below alpha after the correction
};

/// By setting and end: whose answers lie farthest towards the end from the persons' other videos.
std::vector<BestSeen> best_seen(const Gathered& gathered,
                                const std::vector<Comparison>& comparisons);

}  // namespace mien::pipeline
