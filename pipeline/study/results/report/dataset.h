#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A file in the report's folder; `path` is relative to the folder.
struct DatasetFile {
  std::string path;
  std::string bytes;
};

/// Paths of the data files in the dataset.
struct DatasetPaths {
  std::string answers;       ///< "data/study-emotionstudy_description-answers_data.csv"
  std::string stimuli;       ///< "data/study-emotionstudy_description-stimuli_data.csv"
  std::string participants;  ///< "data/study-emotionstudy_description-participants_data.csv"
  std::string traces;        ///< of continuous trials: "…_description-traces_data.csv"
};

/// Paths by the naming rules of Psych-DS, in which keywords and values consist of letters and
/// digits.
DatasetPaths dataset_paths(const std::string& study);

/// The data as a Psych-DS dataset (psych-ds.github.io): the answers, including those of excluded
/// participants, which are marked; the stimuli with their factors; the participants, if known,
/// named as in the answers; dataset_description.json (JSON-LD, schema.org), which describes every
/// column of these; codebook.csv, which also describes the tables of results; README.md; and
/// .psychdsignore.
std::vector<DatasetFile> dataset_files(const Results& results, const std::vector<AnswerRow>& rows,
                                       const std::vector<WrittenTable>& tables);

/// R scripts that read the exported data and are run in their own folder, analysis/, which is next
/// to data/. All have the factors of the report's analysis of variance with their interactions and
/// the planned contrasts; without such an analysis, the factors made, emotion and setting.
///
/// - lme4.R: a linear mixed model of each scale, with random participants and stimuli
/// - ordinal.R: a cumulative link mixed model of each scale with at least three different answers
/// - afex.R: the report's analysis of variance, by another program; only if the report has one
std::vector<DatasetFile> r_scripts(const Results& results);

}  // namespace mien::pipeline
