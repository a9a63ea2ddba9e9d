#include "pipeline/commands/study/answer_inputs.h"

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/results/answer_files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Whether an input counts as a manifest's name: it is neither a table nor a folder.
bool is_manifest(const fs::path& file) {
  return file.extension() != ".csv" && !fs::is_directory(file);
}

}  // namespace

Error no_answers() {
  return Error("no answers were given", "give the CSV that the questionnaire wrote");
}

AnswerInputs inputs_with_or_without_answers(const std::vector<std::string>& files,
                                            const std::vector<std::string>& participants) {
  AnswerInputs inputs;
  std::vector<fs::path> named;
  for (const std::string& name : files) {
    const fs::path file = name;
    if (file.extension() == ".db")
      throw Error(
          {name}, "is the file of answers of a served study",
          "save answers.csv from the experimenter's page (mien study serve), and give that");
    if (is_manifest(file)) {
      if (!inputs.manifest.empty())
        throw Error({name}, "is a second manifest", "give one study at a time");
      inputs.manifest = file;
    } else {
      named.push_back(file);
    }
  }
  AnswerFiles found = answer_files(named);
  inputs.answers = std::move(found.answers);
  if (participants.empty()) inputs.participants = std::move(found.participants);
  for (const std::string& file : participants) inputs.participants.emplace_back(file);
  if (inputs.manifest.empty())
    throw Error("no manifest was given", "give the study's, for example study.yaml");
  return inputs;
}

AnswerInputs answer_inputs(const std::vector<std::string>& files,
                           const std::vector<std::string>& participants) {
  AnswerInputs inputs = inputs_with_or_without_answers(files, participants);
  if (inputs.answers.empty()) throw no_answers();
  return inputs;
}

}  // namespace mien::pipeline
