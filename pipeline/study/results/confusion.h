#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// A row of a confusion matrix: the responses to one intended emotion.
struct ConfusionRow {
  std::string emotion;         ///< level of the factor `emotion`
  std::vector<double> points;  ///< points by column
  double total = 0.0;          ///< sum of the points
  int own = -1;                ///< column of the emotion itself; −1 if there is none
  /// Share of the points in the emotion's own column; NaN without such a column or without points.
  double recall = 0.0;
  /// Wilson's 95 % interval of the recall, with `judged` as the number of trials; NaN if the recall
  /// is.
  double low = 0.0;
  double high = 1.0;
  // A presentation is a stimulus of this emotion, answered by one participant.
  int showings = 0;  ///< number of presentations
  int judged = 0;    ///< number of presentations with any points
  int decided = 0;   ///< number of presentations in which one column has the most points, alone
  int hits = 0;      ///< of these, those in which it is `own`
  /// p of an exact two-sided binomial test of the hits among the decided presentations against
  /// chance: whoever guesses gives any column the most points equally often, but often several of
  /// them as many, which decides nothing. NaN if the recall is, or if nothing is decided.
  double p = 1.0;
  double adjusted = 1.0;  ///< p adjusted over the rows of the matrix

  /// Whether more presentations are hits than by chance.
  bool is_above(double chance) const { return hits > chance * decided; }
};

/// A confusion matrix of intended emotions (rows) and responses (columns).
struct Confusion {
  /// Level of the factor `made`: "acted", "modified"; "other" for stimuli without that factor; or
  /// "all".
  std::string of;
  bool by_points = true;             ///< from ratings; otherwise from choices
  std::vector<std::string> columns;  ///< ends of scales, or choices
  double chance = 0.0;               ///< 1 / number of columns
  std::vector<ConfusionRow> rows;
};

/// Confusion matrices from ratings, by the points rule of the emotion thesis, and from choices. Of
/// each kind, one matrix is for all stimuli with a level of the factor `emotion`. If there are
/// several levels of the factor `made` whose stimuli show emotions, a matrix for each of these
/// levels precedes it, without neutral stimuli.
///
/// By the points rule, a rating contributes up to 2 points to the nearer end of its scale, in
/// proportion to its distance from the middle: 2 at the end, 1 half way. Shares refer to all points
/// of a row. Emotions that are not among the columns have no recall.
std::vector<Confusion> confusions_of(const AnswerSet& answer_set);

/// Names of the ends of the scales in the order of the scales, low before high.
std::vector<std::string> ends_of(const std::vector<Scale>& scales);

/// Points of a rating for the ends of its scale.
struct EndPoints {
  double low = 0.0;
  double high = 0.0;
};
EndPoints points_of(const Scale& scale, double value);

/// The correlation of two ends of scales. Scales are split at their middle: an answer a, relative
/// to the middle, counts as max(−a, 0) for the low end and as max(a, 0) for the high end. The
/// correlation is over presentations (a participant and a stimulus) with answers on both scales.
struct EndCorrelation {
  std::size_t one = 0;      ///< index in ends_of, less than `other`
  std::size_t other = 0;    ///< index in ends_of
  bool same_scale = false;  ///< both are ends of one scale: negative by construction
  Correlation correlation;
  double adjusted = 1.0;  ///< p adjusted over the pairs of ends of different scales
};

/// Correlations of all pairs of ends. The emotion thesis marks |r| above 0.3 and above 0.5.
std::vector<EndCorrelation> end_correlations(const AnswerSet& answer_set);

}  // namespace mien::pipeline
