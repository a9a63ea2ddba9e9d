#include "pipeline/study/questionnaire/experiment/live_export.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/experiment/jatos_archive.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

std::string data_text(const LiveExport& what) {
  return fmt::format(
      "# Data\n\n"
      "Put the files saved by the participants' browsers here, unchanged: for each session\n"
      "{}.\n",
      what.saved_files);
}

std::string readme(const LiveExport& what, const Manifest& manifest,
                   const std::vector<SessionPlan>& plans) {
  const std::string title = title_of(manifest);
  const SessionPlan& first = plans.front();
  std::string text = fmt::format(
      "{}\n"
      "{}\n\n"
      "{} of study {}: {} participants ({} to {}), {} trials, expected\n"
      "to take {} each. Motions are synthesized in the browser; no network is needed and no data "
      "are\n"
      "sent.\n\n",
      title, std::string(title.size(), '='), what.experiment_name, manifest.study, plans.size(),
      first.participant, plans.back().participant, first.trials.size(), duration_text(plans));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (double-click it). At the end the browser downloads\n"
      "    {}.\n"
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
      "    Import {}.jzip (Studies, +, Import). The result data are the CSV of the {},\n"
      "    complete after every trial; the result files hold the rest.\n\n",
      what.saved_files, first.participant, manifest.study, what.trials_file);
  if (what.phones == Phones::refused)
    text += "Participants on phones are turned away with a message, as set in the manifest.\n\n";
  return text + "Analysis\n" + what.analysis;
}

}  // namespace

ZipFiles exported_live(const LiveExport& what, const Manifest& manifest,
                       const nlohmann::ordered_json& experiment,
                       const std::vector<SessionPlan>& plans) {
  ZipFiles files;
  const std::string script = what.page + ".js";
  for (const std::string& name :
       {std::string("LICENSES.txt"), std::string("index.html"), what.page + ".css", script})
    files[name] = read_file(what.pages / name);
  files["experiment.js"] = "globalThis.mienExperiment = " + experiment.dump() + ";\n";
  files["live_core.js"] = what.live_script;
  ZipFiles assets = files;
  assets["index.html"] = jatos_page(std::move(assets["index.html"]), script);
  files[manifest.study + ".jzip"] =
      jatos_archive({.title = title_of(manifest),
                     .description = fmt::format("{} of study {}, {} participants",
                                                what.experiment_name, manifest.study, plans.size()),
                     .folder = manifest.study,
                     .key = fmt::format("{}/{}", manifest.study, manifest.seed)},
                    assets);
  files["experiment.json"] = experiment.dump(1) + "\n";
  files["plans.csv"] = plans_csv(plans);
  files["answers/data/README.md"] = data_text(what);
  files["README.txt"] = readme(what, manifest, plans);
  return files;
}

}  // namespace mien::pipeline
