#pragma once

#include <string>

#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// Scripts for R that read the exported data and fit what mien does not reimplement. They run from
/// the folder they lie in, beside data/.
struct RScripts {
  std::string mixed;    ///< lme4: linear mixed models, scale by scale
  std::string ordinal;  ///< ordinal: cumulative link mixed models, scale by scale
};

/// `answers` and `stimuli` are the paths of the data, relative to the dataset's folder.
RScripts r_scripts(const Gathered& gathered, const std::string& answers,
                   const std::string& stimuli);

}  // namespace mien::pipeline
