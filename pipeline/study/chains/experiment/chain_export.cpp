#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/questionnaire/experiment/live_export.h"

namespace mien::pipeline {

ZipFiles exported_chains(const Manifest& manifest, const ChainStudy& study,
                         const std::filesystem::path& pages, const std::filesystem::path& module) {
  if (adaptive_of(manifest).across_participants)
    throw Error({manifest.file.string()},
                "chains across participants need a server, which gives each participant the next "
                "step",
                "use mien study serve, or remove across_participants");
  const LiveExport what{
      .page = "chains",
      .pages = pages,
      .experiment_name = "Adaptive experiment",
      .live_script = live_script(module, study.bundle),
      .saved_files = "steps and participant (CSV), and the complete record (JSON)",
      .trials_file = "steps",
      .analysis =
          "    Pass the files of all participants, with the manifest:\n"
          "        mien study chains " +
          manifest.study + ".yaml answers/data/*steps*.csv -o chains\n",
      .phones = manifest.adaptive->phones};
  return exported_live(what, manifest, study.experiment, study.plans());
}

}  // namespace mien::pipeline
