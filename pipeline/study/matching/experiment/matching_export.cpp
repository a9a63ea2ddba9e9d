#include "pipeline/study/matching/experiment/matching_export.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/experiment/jatos_archive.h"

namespace mien::pipeline {

namespace {

std::string data_text() {
  return "# Data\n\n"
         "Put the files that participants' browsers saved here, as they are: for each session one\n"
         "of trials, one of every change of a slider, one about the participant, and all that was\n"
         "recorded (JSON).\n";
}

std::string readme(const Manifest& manifest, const MatchingStudy& study) {
  const std::string title = title_of(manifest);
  const SessionPlan& first = study.plans.front();
  std::string text = fmt::format(
      "{}\n{}\n\n"
      "The matching experiment of the study {}: {} participants ({} to {}), {} trials and about "
      "{}\n"
      "minutes each. Motions are made inside the browser: nothing here needs a network, and "
      "nothing\n"
      "is sent anywhere.\n\n",
      title, std::string(title.size(), '='), manifest.study, study.plans.size(), first.participant,
      study.plans.back().participant, first.trials.size(),
      std::ceil(first.expected_seconds / 60.0));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (a double click will do). At the end the browser saves\n"
      "    four files among its downloads: trials, changes and the participant (CSV), and all "
      "that\n"
      "    was recorded (JSON). Who reloads the page begins the running trial anew, and goes "
      "on.\n\n"
      "    The browser takes one of the plans that it has given least often. To say which:\n"
      "        index.html?participant={}\n\n"
      "On a web server\n"
      "    Put index.html, LICENSES.txt and all files that end in .js or .css there.\n\n"
      "On JATOS\n"
      "    Import {}.jzip (Studies, +, Import). The result data is the CSV of the trials, "
      "complete\n"
      "    after every trial; files of results hold the rest.\n\n",
      first.participant, manifest.study);
  if (manifest.matching->phones == Phones::refused)
    text += "Phones are sent away with a friendly word, as the manifest says.\n\n";
  return text + fmt::format(
                    "Afterwards\n"
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
  assets["index.html"] = page_of_jatos(std::move(assets["index.html"]), "matching.js");
  files[manifest.study + ".jzip"] = jatos_archive(
      {.title = title_of(manifest),
       .description = fmt::format("Matching experiment of the study {}, {} participants",
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
