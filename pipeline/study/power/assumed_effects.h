#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/study/power/planned_design.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

// Assumed means of stimuli: a row for each group of participants, a column for each stimulus of the
// design (ScaleTests::tests).

/// An effect with a difference of 1 between first and last level, the other levels in the middle
/// (Cohen 1988, pattern of minimum variability); of an interaction, the difference of these
/// differences.
Eigen::MatrixXd effect_shift(const PlannedDesign& design, const VarianceTerm& term);

/// The smallest means of cells that give a contrast a value of 1.
Eigen::MatrixXd contrast_shift(const PlannedDesign& design, const DesignContrast& contrast);

/// The value of a contrast of such means.
double value_of(const DesignContrast& contrast, const Eigen::MatrixXd& shift);

/// The assumed mean of each stimulus on a scale, which is that of its cell: the mean of the stimuli
/// with the same levels of the analysed factors. Copies of stimuli (with_stimuli_per_cell) count
/// like their originals.
std::vector<double> cell_truth(const Manifest& manifest, const StatedTruth& truth,
                               const std::vector<std::string>& stimuli, const Scale& scale);

}  // namespace mien::pipeline
