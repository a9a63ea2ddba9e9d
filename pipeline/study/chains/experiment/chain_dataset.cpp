#include "pipeline/study/chains/experiment/chain_dataset.h"

#include <set>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/psych_ds.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"

namespace mien::pipeline {

namespace {

std::string description_json(const std::string& study, bool simulated) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::array();
  for (const Column& column : chain_steps_form.columns)
    variables.push_back(psych_ds_variable(column.name, column.meaning, column.unit));
  nlohmann::ordered_json description = psych_ds_description(
      study,
      (simulated ? "SIMULATED answers: " : "") +
          ("answers to the steps of the chains of study " + study +
           ", one row per answer, practice and attention checks included. codebook.csv documents "
           "the columns of the tables computed from them."),
      std::move(variables));
  description["keywords"] = {"adaptive experiment", "human motion"};
  if (simulated) description["keywords"].push_back("simulated");
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return description.dump(2, ' ', false, replace) + "\n";
}

}  // namespace

std::string joined_steps_csv(const std::vector<std::filesystem::path>& files) {
  CsvWriter writer(header_of(chain_steps_form));
  std::set<std::vector<std::string>> written;
  for (const std::filesystem::path& file : files) {
    const CsvTable table = read_csv(file);
    std::vector<std::size_t> columns;
    for (const Column& column : chain_steps_form.columns)
      columns.push_back(static_cast<std::size_t>(require_column(table, std::string(column.name))));
    for (const auto& row : table.rows) {
      std::vector<std::string> fields;
      for (const std::size_t column : columns) fields.push_back(row[column].text);
      if (written.insert(fields).second) writer.row(fields);
    }
  }
  return writer.text();
}

std::vector<std::pair<std::string, std::string>> chain_dataset(
    const std::string& study, const std::vector<std::filesystem::path>& files,
    const std::vector<WrittenTable>& tables, bool simulated) {
  std::string ignored = "codebook.csv\nwords.ratings.csv\nwords.scales.yaml\nprototypes.yaml\n";
  for (const WrittenTable& table : tables) ignored += std::string(table.form.path) + "\n";
  for (const char* figure : {"chains", "prototypes", "densities"})
    for (const char* ending : {".pdf", ".svg", ".png"})
      ignored += std::string(figure) + ending + "\n";
  return {{psych_ds_path(study, "steps"), joined_steps_csv(files)},
          {"dataset_description.json", description_json(study, simulated)},
          {".psychdsignore", ignored}};
}

}  // namespace mien::pipeline
