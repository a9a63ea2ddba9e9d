#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// How one emotion that was shown was seen.
struct ConfusionRow {
  std::string emotion;         ///< level of the factor emotion
  std::vector<double> points;  ///< by what was seen
  double total = 0.0;          ///< of the points
  int own = -1;                ///< column of the emotion itself; −1 where it is none
  /// Share of the points at the emotion's own column; NaN without one, or without points.
  double recall = 0.0;
  /// Wilson's 95 % interval of the recall, with as many trials as there were showings that got any
  /// points: the points of one showing go together.
  double low = 0.0;
  double high = 1.0;
  int showings = 0;  ///< times that somebody judged such a stimulus
  int judged = 0;    ///< of these, those that got any points
  int hits = 0;      ///< showings whose own column got more points than any other
  double p = 1.0;    ///< exact binomial test, two-sided, of the hits against chance
  double adjusted = 1.0;
};

/// Which emotions were taken for which.
struct Confusion {
  std::string of;                    ///< "acted", "modified", "all"
  bool by_points = true;             ///< from ratings; else from choices
  std::vector<std::string> columns;  ///< ends of scales, or what there was to choose from
  double chance = 0.0;               ///< one of the columns
  std::vector<ConfusionRow> rows;
};

/// One for each level of the factor made that shows emotions, and where that is not one alone, of
/// all; of ratings by the points rule of the emotion thesis, and of choices.
///
/// The points rule: an answer gives the end of the scale on which it lies 2 points at that end and
/// 1 half way, in proportion to its distance from the middle; the middle gives none. A row's shares
/// are of all its points. Rows that are no end of a scale have no recall.
std::vector<Confusion> confusions_of(const Gathered& gathered);

/// The ends of the scales, low before high, in their order.
std::vector<std::string> ends_of(const std::vector<Scale>& scales);

/// Points that an answer gives the low end and the high end.
struct EndPoints {
  double low = 0.0;
  double high = 0.0;
};
EndPoints points_of(const Scale& scale, double value);

/// How two ends of scales go together: the scales are split at their middle, an answer a becoming
/// max(−a, 0) at the low end and max(a, 0) at the high end, and the showings (one person, one
/// stimulus) are correlated in which both scales were answered.
struct EndCorrelation {
  std::size_t one = 0;  ///< of the ends (confusion.h), below `other`
  std::size_t other = 0;
  bool same_scale = false;  ///< the two ends of one scale: negative by its making
  Correlation correlation;
  double adjusted = 1.0;  ///< p corrected over the pairs of different scales
};

/// All pairs of ends. The thesis marks |r| above 0.3 and above 0.5.
std::vector<EndCorrelation> end_correlations(const Gathered& gathered);

}  // namespace mien::pipeline
