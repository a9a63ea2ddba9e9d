#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

/// The rows of all tables of steps as one table: practice, attention checks and answers that are
/// not used included. A row that occurs in several files is written once. Throws Error for
/// malformed tables.
std::string joined_steps_csv(const std::vector<std::filesystem::path>& files);

/// What makes a folder of results a Psych-DS dataset: the answers (joined_steps_csv) as
/// data/study-…_description-steps_data.csv, dataset_description.json, which describes their
/// columns, and .psychdsignore, which names everything else: the `tables`, with their paths, and
/// figures. Names and contents.
std::vector<std::pair<std::string, std::string>> chain_dataset(
    const std::string& study, const std::vector<std::filesystem::path>& files,
    const std::vector<WrittenTable>& tables, bool simulated);

}  // namespace mien::pipeline
