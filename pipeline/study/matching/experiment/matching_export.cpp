#include <fmt/format.h>

#include "pipeline/study/live/live_script.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/experiment/live_export.h"

namespace mien::pipeline {

ZipFiles exported_matching(const Manifest& manifest, const MatchingStudy& study,
                           const std::filesystem::path& pages,
                           const std::filesystem::path& module) {
  const LiveExport what{
      .page = "matching",
      .pages = pages,
      .experiment_name = "Matching experiment",
      .live_script = live_script(module, study.bundle),
      .saved_files = "trials, slider changes and participant (CSV), and the complete record (JSON)",
      .trials_file = "trials",
      .analysis = fmt::format("    Put all trials into one file, with one header, and run\n"
                              "        mien study evaluate trials.csv --limit {} -o evaluation\n",
                              manifest.matching->limit_s),
      .phones = manifest.matching->phones};
  return exported_live(what, manifest, study.experiment, study.plans);
}

}  // namespace mien::pipeline
