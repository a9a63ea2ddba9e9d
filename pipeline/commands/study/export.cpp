#include "pipeline/study/questionnaire/experiment/export.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/page_bundle.h"
#include "pipeline/commands/study/matching_design.h"
#include "pipeline/commands/study/prepared_questionnaire.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/experiment/restricted_motions.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  ProductionArguments study;
  std::string folder;
  bool restricted = false;
};

/// Throws Faults if the export would pass on motions that must not be shared.
void refuse_restricted_motions(const ExportOptions& options, const Manifest& manifest) {
  if (options.restricted) return;
  std::vector<Fault> faults = restricted_motions(manifest);
  if (faults.empty()) return;
  for (Fault& fault : faults) fault.remedy += ", or give --restricted if you may pass it on";
  throw Faults(std::move(faults));
}

/// Writes the export of an experiment, unless the folder has answers to another design.
int write_live_export(const Manifest& manifest, const ZipFiles& files, const std::string& design,
                      const std::vector<SessionPlan>& plans, const fs::path& folder,
                      const Console& console) {
  refuse_answers_to_other_design(folder, design);
  write_export(files, folder);
  console.out << fmt::format("{}: {} participants, {} trials each\n{}\n{}\n", folder.string(),
                             plans.size(), plans.front().trials.size(),
                             (folder / "index.html").string(),
                             (folder / (manifest.study + ".jzip")).string());
  return exit_done;
}

int export_live(const Manifest& manifest, const fs::path& folder, const Console& console) {
  const fs::path module = live_module();
  Motions motions(manifest);
  if (manifest.adaptive) {
    const ChainStudy study = chain_study(manifest, motions);
    return write_live_export(manifest,
                             exported_chains(manifest, study, page_bundle("chains"), module),
                             study.experiment.at("design"), study.plans(), folder, console);
  }
  const MatchingStudy study = matching_study(manifest, motions);
  warn_of_matched_at_start(manifest, study, console);
  return write_live_export(manifest,
                           exported_matching(manifest, study, page_bundle("matching"), module),
                           study.experiment.at("design"), study.plans, folder, console);
}

int export_study(const ExportOptions& options, const Console& console) {
  // Errors that would stop the export later are reported before anything is drawn.
  refuse_foreign_folder(options.folder);
  const Manifest asked = participants_manifest(options.study.manifest, console);
  refuse_restricted_motions(options, asked);
  if (asked.matching || asked.adaptive) return export_live(asked, options.folder, console);
  const fs::path pages = page_bundle("questionnaire");
  refuse_answers_to_other_design(options.folder, design_hash(asked, plan_sessions(asked)));
  const PreparedQuestionnaire made = prepared_questionnaire(options.study, console);
  write_export(exported_questionnaire(made.manifest, made.plans, made.media, pages),
               options.folder);
  const fs::path folder = options.folder;
  console.out << fmt::format(
      "{}: {} participants, {} {}\n{}\n{}\n", folder.string(), made.plans.size(), made.media.size(),
      made.media.size() == 1 ? "stimulus" : "stimuli", (folder / "index.html").string(),
      (folder / (made.manifest.study + ".jzip")).string());
  return exit_done;
}

}  // namespace

Command study_export_command() {
  const auto options = std::make_shared<ExportOptions>();
  return {
      .name = "export",
      .summary = "Export the questionnaire or experiment as a folder for any browser and for JATOS",
      .options =
          all_of(questionnaire_options(options->study),
                 option("--folder,-o", &options->folder,
                        "Folder to write, new or of an earlier export; answers in it are kept")
                     .required(),
                 flag("--restricted", &options->restricted,
                      "Export also motions whose licence does not permit sharing "
                      "(licence: {share: false}), which are otherwise refused")),
      .notes =
          "First makes the videos that a questionnaire shows, as mien run does. The folder "
          "works offline (open\n"
          "index.html), on any web server, and on JATOS (.jzip); see its README.txt.\n\n"
          "Example:\n"
          "  mien study export study.yaml -o questionnaire",
      .run = [options](const Console& console) { return export_study(*options, console); }};
}

}  // namespace mien::pipeline
