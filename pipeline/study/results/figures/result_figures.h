#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A figure of the report.
struct ResultFigure {
  std::string name;  ///< base name of its files, by content: "confusion-acted"
  std::string
      section;  ///< section of the page: "histograms", "means", "differences", "confusion" …
  std::string thesis;  ///< number of the corresponding figure in the emotion thesis (README.md);
                       ///< may be empty
  std::string former_name;  ///< earlier base name of its files; may be empty
  std::string caption;      ///< one or more sentences
  Plot plot;
};

/// All figures for which there are answers. Histograms are divided by stimulus_groups(), and
/// further if there are many scales.
std::vector<ResultFigure> result_figures(const Results& results);

/// Adds a mark to a bar chart if its ratings are simulated.
Plot with_simulated_mark(Plot plot, bool simulated);

/// Stimuli whose histograms are plotted in one figure.
struct StimulusGroup {
  std::string name;   ///< "acted"
  std::string words;  ///< noun in captions: "acted motions"
  std::vector<std::size_t> stimuli;
  std::string former_name;  ///< earlier base name of its histogram files
};
/// The acted, modified, neutral and other motions, without empty groups; in studies without acted
/// and modified motions, one group of all stimuli.
std::vector<StimulusGroup> stimulus_groups(const AnswerSet& answer_set);

/// Adds figures of the within-participants differences between modified, acted and neutral motions:
/// over all settings, then by video; and between levels of other factors.
void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds a figure for each scale: the means of the cells of the design with intervals within
/// participants.
void add_factor_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures for each question about pairs: the share of choices of the first stimulus with
/// Wilson's interval, and a line at one half. More than eight pairs are divided among several
/// figures.
void add_pair_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures for each question about pairs: the worths of the stimuli with their intervals.
void add_worth_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds a figure of the means of the conditions of grid trials.
void add_grid_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds a figure for each scale: the mean traces of the stimuli with pointwise intervals. More than
/// twelve stimuli are divided among several figures.
void add_trace_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures of the sensitivities with their intervals, by stimulus or pair and by participant,
/// if there are not too many.
void add_detection_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures of the thresholds of adaptive trials: proportions by level with the fitted
/// functions, levels over the trials, and the participants' thresholds, if there are not too many.
void add_threshold_figures(const Results& results, std::vector<ResultFigure>& figures);

/// Adds figures for each free-text question: the most frequent words by stimulus.
void add_word_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
