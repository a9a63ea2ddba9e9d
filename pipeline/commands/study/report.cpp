#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/archive/zip_archive.h"
#include "pipeline/commands/study/asked_manifest.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/questionnaire/frozen_design.h"
#include "pipeline/questionnaire/simulated_sessions.h"
#include "pipeline/results/results_report.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct ReportCommand {
  std::vector<std::string> files;  ///< answers, and the manifest
  std::vector<std::string> participants;
  std::string out;
  std::string correction;
  int most_failed = -1;
  std::string frozen;
  std::string made;  ///< folder that holds the studies that were made
};

/// What the command line names, told apart by what it is.
struct ReportInputs {
  std::vector<fs::path> answers;
  std::vector<fs::path> participants;
  fs::path manifest;
};

/// Whatever is neither a table nor a folder may name a manifest in one of its ways.
bool is_manifest(const fs::path& file) {
  return file.extension() != ".csv" && !fs::is_directory(file);
}

/// The answers of a folder are its answers.csv, and who gave them lies beside.
ReportInputs inputs_of(const ReportCommand& options) {
  ReportInputs inputs;
  for (const std::string& name : options.files) {
    fs::path file = name;
    if (is_manifest(file)) {
      if (!inputs.manifest.empty())
        throw Error({name}, "is a second manifest", "report each study by itself");
      inputs.manifest = file;
      continue;
    }
    if (fs::is_directory(file)) file /= "answers.csv";
    inputs.answers.push_back(file);
    const fs::path beside = file.parent_path() / "participants.csv";
    const bool is_new = std::ranges::find(inputs.participants, beside) == inputs.participants.end();
    if (options.participants.empty() && is_new && fs::exists(beside))
      inputs.participants.push_back(beside);
  }
  for (const std::string& file : options.participants) inputs.participants.emplace_back(file);
  if (inputs.manifest.empty())
    throw Error("no manifest is named", "give the study's, for example study.yaml");
  if (inputs.answers.empty())
    throw Error("no answers are named", "give the CSV that the questionnaire wrote");
  return inputs;
}

/// The hash of the design that a bundle holds.
std::string frozen_hash(const fs::path& bundle) {
  return nlohmann::json::parse(read_zip(bundle).at("design.json")).value("design", "");
}

FrozenVerdict verdict_on(const ReportCommand& options, const Manifest& manifest,
                         const std::vector<AnswerRow>& rows) {
  if (options.frozen.empty()) return {};
  const fs::path made = fs::path(options.made) / manifest.study;
  FrozenVerdict verdict;
  verdict.differences =
      frozen_differences(options.frozen, manifest, fs::exists(made) ? made : fs::path());
  const std::string frozen = fs::path(options.frozen).filename().string();
  const std::string run = rows.front().design;  // gather has seen that there is no other
  if (!run.empty() && run != frozen_hash(options.frozen))
    verdict.differences.push_back("answers: they were given to the design " + run +
                                  ", which is not the one that was frozen");
  verdict.sentence = verdict.differences.empty()
                         ? fmt::format("What was run is what was frozen in {}.", frozen)
                         : fmt::format("What was run differs from what was frozen in {}:", frozen);
  return verdict;
}

std::optional<TestCorrection> correction_named(const std::string& name) {
  for (const auto& [word, correction] : correction_words)
    if (name == word) return correction;
  return std::nullopt;
}

void tell_results(const Results& results, const FrozenVerdict& frozen, const fs::path& folder,
                  const Console& console) {
  const Gathered& gathered = results.gathered;
  for (const std::string& note : gathered.notes) console.err << note << '\n';
  for (const Attention& own : gathered.attention)
    if (own.is_excluded)
      console.err << fmt::format(
          "participant \"{}\" is left out: {} of {} attention checks passed\n", own.participant,
          own.passed, own.checks);
  if (gathered.simulated) console.out << "simulated answers\n";
  console.out << fmt::format("{} of {} people count\n", gathered.people.size(),
                             gathered.attention.size());
  if (!frozen.sentence.empty()) console.out << frozen.sentence << '\n';
  for (const std::string& difference : frozen.differences)
    console.out << "  " << difference << '\n';
  console.out << (folder / "report.html").string() << '\n';
}

/// Tells answers that were given to another state of the questionnaire than the manifest's.
void note_other_design(const Manifest& manifest, Gathered& gathered) {
  if (gathered.design.empty()) return;
  const std::string now = design_hash(manifest, plan_sessions(manifest));
  if (gathered.design != now)
    gathered.notes.push_back(fmt::format(
        "The answers were given to the design {}; the manifest is now {}.", gathered.design, now));
}

int report(const ReportCommand& options, const Console& console) {
  const ReportInputs inputs = inputs_of(options);
  const Manifest manifest = asked_manifest(inputs.manifest.string(), console);
  std::vector<AnswerRow> rows = read_answer_rows(inputs.answers);
  std::vector<ParticipantTable> tables;
  for (const fs::path& file : inputs.participants) tables.push_back(read_participants(file));
  ReportChoices choices;
  choices.correction = correction_named(options.correction);
  if (options.most_failed >= 0) choices.most_failed = options.most_failed;
  Gathered gathered = gather(manifest, rows, choices);
  note_other_design(manifest, gathered);
  const FrozenVerdict frozen = verdict_on(options, manifest, rows);
  const Results results = results_of(std::move(gathered), rows, joined(tables));
  const fs::path folder =
      options.out.empty() ? fs::path("out") / (manifest.study + "-results") : fs::path(options.out);
  clear_results_folder(folder);
  write_results(results, rows, frozen, folder);
  tell_results(results, frozen, folder, console);
  return exit_done;
}

}  // namespace

void add_study_report_command(CLI::App& study, Command& chosen) {
  CLI::App* command = study.add_subcommand(
      "report", "From a questionnaire's answers to tables, figures and one page");
  const auto options = std::make_shared<ReportCommand>();
  command
      ->add_option("files", options->files,
                   "Answers (CSV, or folders that hold answers.csv) and the manifest of the study, "
                   "in either order")
      ->required();
  command->add_option("-o,--output", options->out,
                      "Folder to write; out/<study>-results without it");
  command->add_option("--participants", options->participants,
                      "Tables of participants; otherwise participants.csv beside the answers");
  command
      ->add_option("--correction", options->correction,
                   "For the number of tests: holm, bh (Benjamini-Hochberg) or none; otherwise as "
                   "the manifest says")
      ->check(CLI::IsMember({"holm", "bh", "none"}));
  command
      ->add_option("--most-failed", options->most_failed,
                   "Who fails more attention checks is left out; otherwise as the manifest says")
      ->check(CLI::Range(0, 1000));
  command->add_option("--frozen", options->frozen,
                      "Bundle of mien study design --freeze: tell what differs from it");
  command
      ->add_option("--made", options->made,
                   "With --frozen: folder in which the study was made, whose media are compared")
      ->default_str("out");
  options->made = "out";
  command->footer(
      "\nExamples:\n"
      "  mien study report answers.csv study.yaml -o out/results\n"
      "  mien study report lab/ online/ study.yaml --correction bh --frozen design.zip");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return report(*options, console); };
  });
}

}  // namespace mien::pipeline
