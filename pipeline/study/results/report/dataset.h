#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A file of the report's folder.
struct DatasetFile {
  std::string path;
  std::string bytes;
};

/// Paths of the data files in the dataset.
struct DatasetPaths {
  std::string answers;       ///< "data/study-emotionstudy_description-answers_data.csv"
  std::string stimuli;       ///< likewise -stimuli_
  std::string participants;  ///< likewise -participants_
};

/// Paths by the naming rules of Psych-DS: keywords and values of letters and digits.
DatasetPaths dataset_paths(const std::string& study);

/// The data as a Psych-DS dataset (psych-ds.github.io): the answers as read, including excluded
/// participants; the stimuli with their factors; the participants, where known;
/// dataset_description.json (JSON-LD, schema.org), which describes every column; and codebook.csv,
/// which also describes the tables of results.
std::vector<DatasetFile> dataset_files(const Results& results, const std::vector<AnswerRow>& rows,
                                       const std::vector<WrittenTable>& tables);

/// R scripts that read the exported data and fit models that mien does not implement. They run from
/// their own folder, beside data/.
struct RScripts {
  std::string mixed;    ///< lme4: linear mixed models, scale by scale
  std::string ordinal;  ///< ordinal: cumulative link mixed models, scale by scale
};

/// `answers` and `stimuli` are the paths of the data, relative to the dataset's folder.
RScripts r_scripts(const AnswerSet& answer_set, const std::string& answers,
                   const std::string& stimuli);

}  // namespace mien::pipeline
