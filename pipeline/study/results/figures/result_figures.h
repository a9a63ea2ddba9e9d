#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A drawing of the report.
struct ResultFigure {
  std::string name;     ///< of its files, by what it shows: "confusion-acted"
  std::string section;  ///< of the page: "histograms", "means", "differences", "confusion" …
  std::string thesis;   ///< number of the figure of the emotion thesis that it is like; or empty
  std::string was;      ///< what its files were called before they were named by content; or empty
  std::string caption;  ///< a sentence
  Plot plot;
};

/// All that the answers make possible. Studies without acted and modified stimuli have one figure
/// of all stimuli where others have one of either.
std::vector<ResultFigure> result_figures(const Results& results);

/// Of bar charts, which say in their own words that sessions are simulated: here ratings are.
Plot marked(Plot plot, bool simulated);

/// A group of stimuli that are shown together.
struct StimulusGroup {
  std::string name;   ///< "acted"
  std::string words;  ///< "acted motions"
  std::vector<std::size_t> stimuli;
  std::string was;  ///< what its histograms were called before they were named by content
};
std::vector<StimulusGroup> stimulus_groups(const Gathered& gathered);

/// Modified, acted and neutral motions against each other, within persons: over all settings, then
/// video by video.
void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Of each question asked about pairs: how often the first of either pair was chosen, with Wilson's
/// interval, against one half; a few pairs a figure.
void add_pair_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Of each question answered in words: the words that most people gave, stimulus by stimulus.
void add_word_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
