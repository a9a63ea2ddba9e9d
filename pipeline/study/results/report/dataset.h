#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/results/gathered_answers.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/results.h"

namespace mien::pipeline {

/// A file of the report's folder.
struct DatasetFile {
  std::string path;
  std::string bytes;
};

/// Paths of the data.
struct DatasetPaths {
  std::string answers;       ///< "data/study-emotionstudy_description-answers_data.csv"
  std::string stimuli;       ///< likewise -stimuli_
  std::string participants;  ///< likewise -participants_
};

/// Names after Psych-DS: keywords and values of letters and figures alone.
DatasetPaths dataset_paths(const std::string& study);

/// The folder's data as a Psych-DS dataset (psych-ds.github.io): the answers as they were read,
/// with whom the report leaves out; the stimuli and their factors; the participants, where they are
/// known; dataset_description.json (JSON-LD, schema.org) that tells every column of them, and
/// codebook.csv that tells those of the tables of results too.
std::vector<DatasetFile> dataset_files(const Results& results, const std::vector<AnswerRow>& rows,
                                       const std::vector<WrittenTable>& tables);

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
