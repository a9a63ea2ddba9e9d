#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/parameter_table.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// What people think of each example: the impression matrix A of the adjective paper, section 3.
struct Impressions {
  std::vector<std::string> scales;    ///< ids, one a row
  std::vector<std::string> examples;  ///< names, one a column
  Eigen::MatrixXd mean;  ///< of the answers, as shares of the scale's range: 0 low, 1 high
  Eigen::MatrixXd
      deviation;          ///< standard deviation over participants (n), same unit; NaN for means
  Eigen::MatrixXi count;  ///< answers
  bool simulated = false;
};

/// Averages the answers. Scales without any answer are left out; answers about stimuli that are no
/// examples are ignored. Throws Error that names the examples (and scales) without an answer.
Impressions impressions_of(const Answers& answers, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples);

/// The scales and groups of scales as parameters. A group's row is the mean of its members' rows
/// (A' of the adjective paper); members that were not rated do not count, and a group none of whose
/// members was rated is left out.
ParameterTable parameter_table(const Impressions& impressions, const ScaleSet& scales);

extern const TableForm impressions_form;

/// What people think of the examples.
std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales);

}  // namespace mien::pipeline
