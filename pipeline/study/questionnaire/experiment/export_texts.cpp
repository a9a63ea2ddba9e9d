#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/shell_word.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/study/questionnaire/experiment/export.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

ordered_json variable(std::string_view name, std::string_view meaning, std::string_view unit = "") {
  ordered_json made = {{"@type", "PropertyValue"}, {"name", name}, {"description", meaning}};
  if (!unit.empty()) made["unitText"] = unit;
  return made;
}

double longest_minutes(const std::vector<SessionPlan>& plans) {
  double seconds = 0.0;
  for (const SessionPlan& plan : plans) seconds = std::max(seconds, plan.expected_seconds);
  return seconds / 60.0;
}

}  // namespace

ordered_json dataset_description(const Manifest& manifest) {
  ordered_json variables = ordered_json::array();
  for (const Column& column : answer_form.columns)
    variables.push_back(variable(column.name, column.meaning, column.unit));
  for (const char* name : {"consented_at", "finished"})
    variables.push_back(variable(name, find_column(participant_form, name)->meaning));
  for (const Demographic& question : questionnaire_of(manifest).demographics)
    variables.push_back(variable(question.id, question.ask));
  return {{"@context", "https://schema.org/"},
          {"@type", "Dataset"},
          {"name", title_of(manifest)},
          {"description", fmt::format("Answers to the questionnaire of study {}: one row per "
                                      "answer, and one row per participant.",
                                      manifest.study)},
          {"variableMeasured", variables}};
}

std::string data_folder_text() {
  return "# Answers\n\n"
         "Put the files saved by the participants' browsers here, unchanged: for each session\n"
         "one file of answers and one about the participant. ../dataset_description.json "
         "documents\n"
         "their columns.\n";
}

std::string lab_text(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::string& first = plans.front().participant;
  const std::string& last = plans.back().participant;
  std::string text = fmt::format(
      "{}\n"
      "{}\n\n"
      "Questionnaire of study {}: {} participants ({} to {}), at most about {} minutes each. No\n"
      "network is needed and no data are sent.\n\n",
      title_of(manifest), std::string(title_of(manifest).size(), '='), manifest.study, plans.size(),
      first, last, std::max(1.0, std::ceil(longest_minutes(plans))));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (double-click it). At the end the browser downloads three\n"
      "    files: answers and participant (CSV), and the complete record (JSON). Participants\n"
      "    resume after reloading.\n\n"
      "    The browser assigns one of the plans it has used least often. To choose a plan:\n"
      "        index.html?participant={}\n\n"
      "On a web server\n"
      "    Upload index.html, questionnaire.js, questionnaire.css, experiment.js{} and media/.\n"
      "    The files are saved on the participant's computer, as above. experiment.js reveals "
      "which\n"
      "    video is which to those who read scripts; mien study serve does not, and collects the\n"
      "    answers.\n\n"
      "On JATOS\n"
      "    Import {}.jzip (Studies, +, Import). Each participant of a batch gets one of the plans\n"
      "    used least often in it; ?participant={} in the link chooses a plan. The result data "
      "are\n"
      "    the CSV of the answers, complete after every answer; the result files hold the "
      "rest.\n\n",
      first, asked.view == ShownAs::turn ? ", turn_view.js" : "", manifest.study, first);
  if (asked.phones == Phones::refused)
    text += "Participants on phones are turned away with a message, as set in the manifest.\n\n";
  text += fmt::format(
      "Analysis\n"
      "    Put the CSV files into answers/data and run\n"
      "        mien study report answers/data/*answers_data.csv {} -o report\n\n"
      "plans.csv lists every trial of every participant; experiment.json is the content of the\n"
      "page. File names do not reveal what a video shows, but plans.csv and experiment.json do: "
      "do\n"
      "not show these two to participants.\n",
      motion::shell_path(manifest.file.filename().string()));
  return text;
}

}  // namespace mien::pipeline
