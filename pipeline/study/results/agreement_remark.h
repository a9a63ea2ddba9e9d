#pragma once

#include <string>

#include "pipeline/base/statistics/agreement.h"

namespace mien::pipeline {

/// Why there are no coefficients of agreement, or what negative ones mean, as a short remark; empty
/// if nothing is to be said. `answers`: stimuli × raters, with NaN for missing answers, from which
/// `agreement` was computed; `many`: what is rated ("videos").
std::string agreement_remark(const Eigen::MatrixXd& answers, const Agreement& agreement,
                             const std::string& many);

/// Whether a remark is that there are no coefficients.
bool states_none(const std::string& remark);

/// Sets all coefficients to NaN.
void set_none(Intraclass& intraclass, double& alpha);

}  // namespace mien::pipeline
