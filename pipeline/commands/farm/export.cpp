#include <memory>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/farm/submission_options.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/line/recording_options.h"
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
  const JournalSubmission requested = requested_submission(options, {});
  FarmStudy study(command.study, console);
  const nlohmann::ordered_json job =
      open_job_template(all_stages(study, requested), study.call(command.study), requested.request);
  if (command.file.empty()) {
    console.out << open_job_text(job, "job.json");
    return exit_done;
  }
  refuse_own_input(command.study.manifest, command.file);
  write_file(command.file, open_job_text(job, command.file));
  console.out << command.file << ": a job template of " << job.at("steps").size() << " steps\n";
  return exit_done;
}

}  // namespace

Command farm_export_command() {
  const auto options = std::make_shared<ExportCommand>();
  return {
      .name = "export",
      .summary = "Export a study as a job for other render farms",
      .options = {argument("manifest", &options->study.manifest,
                           "Manifest (YAML), the name of an installed manifest (listed by mien "
                           "manifests), or a study's provenance.json"),
                  option("--format", &options->format,
                         "openjd: a job template of Open Job Description")
                      .one_of({"openjd"})
                      .required(),
                  option("-o,--output", &options->file,
                         "File to write (.json, .yaml); standard output without it"),
                  option("--out", &options->study.out,
                         "Folder of all studies, which all machines share")
                      .with_default(),
                  quality_option(options->study.quality),
                  option("--chunk", &options->chunk,
                         "Maximum number of frames per task: auto, or a number"),
                  option("--jobs,-j", &options->jobs, "Processors per task (1)").between(1, 1024)},
      .notes =
          "The job covers the whole study; tasks skip what exists already.\n\n"
          "Example:\n"
          "  mien farm export my.yaml --format openjd -o my.job.json --out /shared/studies",
      .run = [options](const Console& console) { return export_study(*options, console); }};
}

}  // namespace mien::pipeline
