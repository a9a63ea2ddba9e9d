#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A figure of the report.
struct ResultFigure {
  std::string name;         ///< of its files, by what it shows: "confusion-acted"
  std::string section;      ///< of the page: "histograms", "means", "differences", "confusion" …
  std::string thesis;       ///< number of the corresponding figure of the emotion thesis; or empty
  std::string former_name;  ///< earlier name of its files; or empty
  std::string caption;      ///< a sentence
  Plot plot;
};

/// All figures for which there are answers. Studies without the levels acted and modified have one
/// figure of all stimuli where others have one for each level.
std::vector<ResultFigure> result_figures(const Results& results);

/// Adds a mark to a bar chart where its ratings are simulated.
Plot with_simulated_mark(Plot plot, bool simulated);

/// A group of stimuli that are shown together.
struct StimulusGroup {
  std::string name;   ///< "acted"
  std::string words;  ///< "acted motions"
  std::vector<std::size_t> stimuli;
  std::string former_name;  ///< earlier name of its histograms
};
std::vector<StimulusGroup> stimulus_groups(const AnswerSet& answer_set);

/// Adds figures of the differences between modified, acted and neutral motions within participants:
/// over all settings, then by video.
void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures for each question about pairs: the share of choices of the first stimulus with
/// Wilson's interval, and the line of one half; a few pairs in each figure.
void add_pair_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures for each free-text question: the most frequent words by stimulus.
void add_word_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
