#pragma once

#include <string>
#include <vector>

#include "pipeline/drawing/plot.h"
#include "pipeline/results/results.h"

namespace mien::pipeline {

/// A drawing of the report.
struct ResultFigure {
  std::string name;     ///< of its files: "figure-33-confusion-acted"
  std::string section;  ///< of the page: "histograms", "means", "differences", "confusion" …
  std::string thesis;   ///< number of the figure of the emotion thesis that it is like; or empty
  std::string caption;  ///< a sentence
  Plot plot;
};

/// All that the answers make possible. Studies without acted and modified stimuli have one figure
/// of all stimuli where others have one of either.
std::vector<ResultFigure> result_figures(const Results& results);

/// "figure-35-differences": what is like no figure of the thesis has its name alone.
std::string name_after_thesis(const std::string& thesis, const std::string& name);

/// Of bar charts, which say in their own words that sessions are simulated: here ratings are.
Plot marked(Plot plot, bool simulated);

/// A group of stimuli that are shown together, and the figures of the thesis that it is like.
struct StimulusGroup {
  std::string name;   ///< "acted"
  std::string words;  ///< "acted motions"
  std::vector<std::size_t> stimuli;
  std::string histograms, confusion, table;  ///< numbers of figures
};
std::vector<StimulusGroup> stimulus_groups(const Gathered& gathered);

}  // namespace mien::pipeline
