#include "pipeline/commands/study/prepared_questionnaire.h"

#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/run/continuous_films.h"

namespace mien::pipeline {

PreparedQuestionnaire prepared_questionnaire(const ProductionArguments& arguments,
                                             const Console& console) {
  const std::filesystem::path file = resolve_manifest(arguments.manifest, console);
  // Its warnings have been printed: participants_manifest read it before.
  Manifest manifest = load_manifest(file, process_environment(), arguments.out);
  questionnaire_of(manifest);
  ProductionArguments shown = arguments;
  shown.only = shown_stimuli(manifest);
  Production production(with_media(std::move(manifest)), options_of(shown));
  PreparedQuestionnaire made;
  made.manifest = production.manifest();
  made.folder = folder_of(arguments, made.manifest);
  make_study(production, made.folder, arguments, console);
  if (made.manifest.output.quality == Quality::draft)
    console.err << "note: the videos are of draft quality; give --quality standard or final, or "
                   "output.quality in the manifest, before participants see them\n";
  made.plans = plan_sessions(made.manifest);
  made.media = media_of(made.manifest, made.plans, made.folder);
  VideoSeconds seconds;
  for (const auto& [stimulus, media] : made.media) seconds[stimulus] = media.seconds;
  check_continuous_films(made.manifest, seconds);
  made.plans = plan_sessions(made.manifest, seconds);
  return made;
}

std::vector<CommandOption> questionnaire_options(ProductionArguments& arguments) {
  return {argument("manifest", &arguments.manifest,
                   "Manifest (YAML) with a questionnaire or an experiment, or the name of "
                   "an installed manifest (listed by mien manifests)"),
          option("--out", &arguments.out, "Folder of all studies").with_default(),
          quality_option(arguments.quality),
          option("--jobs,-j", &arguments.jobs, "Number of threads (default: one per processor)")
              .between(1, 1024)};
}

}  // namespace mien::pipeline
