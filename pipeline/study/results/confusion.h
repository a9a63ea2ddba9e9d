#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// A row of a confusion matrix: the responses to one intended emotion.
struct ConfusionRow {
  std::string emotion;         ///< level of the factor emotion
  std::vector<double> points;  ///< by column
  double total = 0.0;          ///< of the points
  int own = -1;                ///< column of the emotion itself; −1 without one
  /// Share of the points in the emotion's own column; NaN without one, or without points.
  double recall = 0.0;
  /// Wilson's 95 % interval of the recall, with `judged` as the number of trials.
  double low = 0.0;
  double high = 1.0;
  int showings = 0;  ///< number of presentations of such stimuli that were answered
  int judged = 0;    ///< presentations with any points
  int hits = 0;      ///< presentations whose own column has the most points
  double p = 1.0;    ///< exact binomial test, two-sided, of the hits against chance
  double adjusted = 1.0;
};

/// A confusion matrix of emotions.
struct Confusion {
  std::string of;                    ///< "acted", "modified", "all"
  bool by_points = true;             ///< from ratings; else from choices
  std::vector<std::string> columns;  ///< ends of scales, or choices
  double chance = 0.0;               ///< 1 / number of columns
  std::vector<ConfusionRow> rows;
};

/// Matrices for each level of the factor `made` that shows emotions, and for all where there are
/// several; from ratings by the points rule of the emotion thesis, and from choices.
///
/// The points rule: a rating gives the nearer end of its scale up to 2 points, in proportion to its
/// distance from the middle: 2 at the end, 1 half way. Shares are of all points of a row. Emotions
/// that are not an end of a scale have no recall.
std::vector<Confusion> confusions_of(const AnswerSet& answer_set);

/// The ends of the scales, low before high, in their order.
std::vector<std::string> ends_of(const std::vector<Scale>& scales);

/// Points of a rating for the ends of its scale.
struct EndPoints {
  double low = 0.0;
  double high = 0.0;
};
EndPoints points_of(const Scale& scale, double value);

/// The correlation of two ends of scales. Scales are split at their middle: an answer a is max(−a,
/// 0) at the low end and max(a, 0) at the high end. The correlation is over presentations (a
/// participant and a stimulus) with answers on both scales.
struct EndCorrelation {
  std::size_t one = 0;  ///< of the ends (confusion.h), below `other`
  std::size_t other = 0;
  bool same_scale = false;  ///< the two ends of one scale: negative by construction
  Correlation correlation;
  double adjusted = 1.0;  ///< p corrected over the pairs of different scales
};

/// All pairs of ends. The thesis marks |r| above 0.3 and above 0.5.
std::vector<EndCorrelation> end_correlations(const AnswerSet& answer_set);

}  // namespace mien::pipeline
