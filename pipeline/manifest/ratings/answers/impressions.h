#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/parameter_table.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The mean ratings of each example: the impression matrix A of the adjective paper, section 3.
struct Impressions {
  std::vector<std::string> scales;    ///< ids, one per row
  std::vector<std::string> examples;  ///< names, one per column
  Eigen::MatrixXd mean;       ///< mean answers as shares of the scale's range: 0 low, 1 high
  Eigen::MatrixXd deviation;  ///< standard deviation over participants (divided by n), same unit;
                              ///< NaN if the answers are means
  Eigen::MatrixXi count;      ///< number of answers; 1 for a given mean
  bool simulated = false;
};

/// Averages the answers. Scales without any answer are omitted; answers about stimuli that are not
/// examples are ignored. Throws Error if no answer is about an example, or if an example has no
/// answer on one of these scales.
Impressions impressions_of(const Answers& answers, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples);

/// Returns the groups of scales, then the scales, as parameters. A group's row is the mean of its
/// members' rows (A' of the adjective paper). Unrated members are ignored, and groups without rated
/// members are omitted.
ParameterTable parameter_table(const Impressions& impressions, const ScaleSet& scales);

extern const TableForm impressions_form;

/// Returns the impressions as CSV.
std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales);

}  // namespace mien::pipeline
