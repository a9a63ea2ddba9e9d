#include "pipeline/study/questionnaire/experiment/export_texts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/shell_word.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"

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
          {"description", fmt::format("Answers to the questionnaire of the study {}: one row an "
                                      "answer, and one row a participant.",
                                      manifest.study)},
          {"variableMeasured", variables}};
}

std::string data_folder_text() {
  return "# Answers\n\n"
         "Put the files that participants' browsers saved here, as they are: for each session\n"
         "one of answers and one about the participant. What their columns mean stands in\n"
         "../dataset_description.json.\n";
}

std::string lab_text(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::string& first = plans.front().participant;
  const std::string& last = plans.back().participant;
  std::string text = fmt::format(
      "{}\n{}\n\n"
      "The questionnaire of the study {}: {} participants ({} to {}), at most about {} minutes\n"
      "each. Nothing here needs a network, and nothing is sent anywhere.\n\n",
      title_of(manifest), std::string(title_of(manifest).size(), '='), manifest.study, plans.size(),
      first, last, std::max(1.0, std::ceil(longest_minutes(plans))));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (a double click will do). At the end the browser saves\n"
      "    three files among its downloads: the answers and the participant (CSV), and all that\n"
      "    was recorded (JSON). Who reloads the page goes on where he stopped.\n\n"
      "    The browser takes one of the plans that it has given least often. To say which:\n"
      "        index.html?participant={}\n\n"
      "On a web server\n"
      "    Put index.html, questionnaire.js, questionnaire.css, experiment.js{} and media/ there.\n"
      "    The files are saved on the participant's computer, as above. experiment.js tells which\n"
      "    video is which to those who read scripts; mien study serve keeps that to itself, and\n"
      "    collects the answers.\n\n"
      "On JATOS\n"
      "    Import {}.jzip (Studies, +, Import). Each participant of a batch gets a plan that was\n"
      "    given least often in it; the link's ?participant={} says which. The result data is the\n"
      "    CSV of the answers, complete after every answer; files of results hold the rest.\n\n",
      first, asked.view == ShownAs::turn ? ", turn_view.js" : "", manifest.study, first);
  if (asked.phones == Phones::refused)
    text += "Phones are sent away with a friendly word, as the manifest says.\n\n";
  text += fmt::format(
      "Afterwards\n"
      "    Put the CSV files into answers/data and run\n"
      "        mien study report answers/data/*answers_data.csv {} -o report\n\n"
      "plans.csv lists every trial of every participant; experiment.json is what the page shows.\n"
      "File names tell nothing of what a video shows; plans.csv and experiment.json do: do not\n"
      "show these two to participants.\n",
      motion::shell_path(manifest.file.filename().string()));
  return text;
}

}  // namespace mien::pipeline
