#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/experiment/jatos_archive.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

std::string data_text() {
  return "# Data\n\n"
         "Put the files saved by the participants' browsers here, unchanged: for each session one\n"
         "file of trials, one of slider changes, one about the participant, and the complete "
         "record\n"
         "(JSON).\n";
}

std::string readme(const Manifest& manifest, const MatchingStudy& study) {
  const std::string title = title_of(manifest);
  const SessionPlan& first = study.plans.front();
  std::string text = fmt::format(
      "{}\n"
      "{}\n\n"
      "Matching experiment of study {}: {} participants ({} to {}), {} trials, expected\n"
      "to take {} each. Motions are synthesized in the browser; no network is needed and no data "
      "are\n"
      "sent.\n\n",
      title, std::string(title.size(), '='), manifest.study, study.plans.size(), first.participant,
      study.plans.back().participant, first.trials.size(), duration_text(study.plans));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (double-click it). At the end the browser downloads four\n"
      "    files: trials, slider changes and participant (CSV), and the complete record (JSON).\n"
      "    Participants resume after reloading, restarting the current trial.\n\n"
      "    The browser assigns one of the plans it has used least often. To choose a plan:\n"
      "        index.html?participant={}\n\n"
      "    index.html?experimenter shows you what this browser keeps: data, to save again, and\n"
      "    who has withdrawn. These see their last page again until you press \"Start for the "
      "next\n"
      "    participant\" there; \"Forget everything\" is for trial runs.\n\n"
      "On a web server\n"
      "    Upload index.html, LICENSES.txt and all files ending in .js or .css. The files are\n"
      "    saved on the participant's computer; the last page lists them and asks to send them to\n"
      "    you. Say how in the ending of the manifest.\n\n"
      "On JATOS\n"
      "    Import {}.jzip (Studies, +, Import). The result data are the CSV of the trials, "
      "complete\n"
      "    after every trial; the result files hold the rest.\n\n",
      first.participant, manifest.study);
  if (manifest.matching->phones == Phones::refused)
    text += "Participants on phones are turned away with a message, as set in the manifest.\n\n";
  return text + fmt::format(
                    "Analysis\n"
                    "    Put all trials into one file, with one header, and run\n"
                    "        mien study evaluate trials.csv --limit {} -o evaluation\n",
                    manifest.matching->limit_s);
}

}  // namespace

ZipFiles exported_matching(const Manifest& manifest, const MatchingStudy& study,
                           const std::filesystem::path& pages,
                           const std::filesystem::path& module) {
  ZipFiles files;
  for (const char* name : {"LICENSES.txt", "index.html", "matching.css", "matching.js"})
    files[name] = read_file(pages / name);
  files["experiment.js"] = "globalThis.mienExperiment = " + study.experiment.dump() + ";\n";
  files["live_core.js"] = live_script(module, study.bundle);
  ZipFiles assets = files;
  assets["index.html"] = jatos_page(std::move(assets["index.html"]), "matching.js");
  files[manifest.study + ".jzip"] =
      jatos_archive({.title = title_of(manifest),
                     .description = fmt::format("Matching experiment of study {}, {} participants",
                                                manifest.study, study.plans.size()),
                     .folder = manifest.study,
                     .key = fmt::format("{}/{}", manifest.study, manifest.seed)},
                    assets);
  files["experiment.json"] = study.experiment.dump(1) + "\n";
  files["plans.csv"] = plans_csv(study.plans);
  files["answers/data/README.md"] = data_text();
  files["README.txt"] = readme(manifest, study);
  return files;
}

}  // namespace mien::pipeline
