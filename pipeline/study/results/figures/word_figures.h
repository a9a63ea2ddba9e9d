#pragma once

#include <vector>

#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

/// Of each question answered in words: the words that most people gave, stimulus by stimulus.
void add_word_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
