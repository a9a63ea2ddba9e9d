#include "pipeline/commands/farm/farm.h"

#include <utility>

#include "motion/text/shell_word.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

ProductionOptions production_options(const FarmArguments& arguments) {
  ProductionArguments all;
  all.manifest = arguments.manifest;
  all.out = arguments.out;
  all.quality = arguments.quality;
  return options_of(all);
}

}  // namespace

fs::path absolute_path(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

std::vector<CommandOption> farm_options(FarmArguments& arguments) {
  return {argument("manifest", &arguments.manifest,
                   "Manifest (YAML), the name of an installed manifest (listed by mien manifests), "
                   "or a study's provenance.json"),
          option("--out,-o", &arguments.out,
                 "Folder of all studies, which all machines share; results go to <out>/<study>")
              .with_default(),
          quality_option(arguments.quality)};
}

FarmManifest::FarmManifest(const FarmArguments& arguments, const Console& console)
    : file(absolute_path(resolve_manifest(arguments.manifest, console))),
      manifest(load_with_warnings(file, arguments.out, console)),
      folder(absolute_path(arguments.out) / manifest.study) {}

FarmStudy::FarmStudy(FarmManifest read, const FarmArguments& arguments)
    : file(std::move(read.file)),
      production(std::move(read.manifest), production_options(arguments)),
      folder(std::move(read.folder)) {}

StudyCall FarmStudy::call(const FarmArguments& arguments) const {
  StudyCall call;
  call.program = fs::read_symlink("/proc/self/exe");
  call.manifest = file;
  call.out = absolute_path(arguments.out);
  call.started = fs::current_path();
  call.study = production.manifest().study;
  call.quality = arguments.quality;
  call.key = key_of(production.graph());
  return call;
}

std::string study_arguments(const FarmArguments& arguments) {
  std::string study_text = motion::shell_path(arguments.manifest);
  if (arguments.out != "out") study_text += " --out " + motion::shell_path(arguments.out);
  if (!arguments.quality.empty()) study_text += " --quality " + arguments.quality;
  return study_text;
}

Command farm_command() {
  return {.name = "farm",
          .summary = "Run a study on many machines, with or without Slurm",
          .commands = {farm_submit_command(), farm_status_command(), farm_logs_command(),
                       farm_resume_command(), farm_cancel_command(), farm_export_command(),
                       farm_worker_command()},
          .notes =
              "mien farm submit submits a study to Slurm, status shows its progress, and resume "
              "submits whatever is missing after any failure. Artifacts that are up to date are "
              "not made again. Without Slurm, start workers."};
}

}  // namespace mien::pipeline
