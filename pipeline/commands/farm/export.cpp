#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/farm/submission_options.h"
#include "pipeline/farm/open_job_description.h"

namespace mien::pipeline {

namespace {

struct ExportCommand {
  FarmArguments study;
  std::string format;
  std::string file;
  std::string chunk;
  std::optional<int> jobs;
};

int export_study(const ExportCommand& command, const Console& console) {
  SubmissionOptions options;
  options.chunk = command.chunk;
  options.jobs = command.jobs;
  const JournalSubmission asked = asked_for(options, {});
  FarmStudy study(command.study, console);
  const nlohmann::ordered_json job =
      open_job_template(all_stages(study, asked), study.call(command.study), asked.request);
  if (command.file.empty()) {
    console.out << open_job_text(job, "job.yaml");
    return exit_done;
  }
  write_file(command.file, open_job_text(job, command.file));
  console.out << command.file << ": a job template of " << job.at("steps").size() << " steps\n";
  return exit_done;
}

}  // namespace

void add_farm_export_command(CLI::App& farm, Command& chosen) {
  CLI::App* command = farm.add_subcommand("export", "A study as a job of other render farms");
  const auto options = std::make_shared<ExportCommand>();
  command
      ->add_option(
          "manifest", options->study.manifest,
          "Manifest (YAML), the name of one of mien manifests, or a study's provenance.json")
      ->required();
  command->add_option("--format", options->format, "openjd: a job template of Open Job Description")
      ->check(CLI::IsMember({"openjd"}))
      ->required();
  command->add_option("-o,--output", options->file,
                      "File to write (.yaml, .json); standard output without it");
  command
      ->add_option("--out", options->study.out, "Folder of all studies, which all machines share")
      ->capture_default_str();
  command->add_option("--quality", options->study.quality, "Instead of the manifest's quality")
      ->check(CLI::IsMember({"draft", "standard", "final"}));
  command->add_option("--chunk", options->chunk,
                      "Frames that a task draws at most: auto, or a number");
  command->add_option("--jobs,-j", options->jobs, "Processors of a task (1)")
      ->check(CLI::Range(1, 1024));
  command->footer(
      "\nAll of the study, whether it is there or not: tasks find what is.\n\nExample:\n"
      "  mien farm export my.yaml --format openjd -o my.job.yaml --out /shared/studies");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return export_study(*options, console); };
  });
}

}  // namespace mien::pipeline
