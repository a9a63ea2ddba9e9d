#include "pipeline/study/questionnaire/experiment/export.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/safe_name.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/base/documents/psych_ds.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/study/questionnaire/experiment/jatos_archive.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// A page opened from a file cannot fetch a motion file next to it, but can load it as a script.
std::string as_script(const std::string& token, std::string_view bytes) {
  return fmt::format("(globalThis.mienMedia ?\?= {{}})[\"{}\"] = \"{}\";\n", token,
                     in_base64(bytes));
}

/// Adds a media file and, unless it is a video, its script.
void add_media(ZipFiles& files, const std::string& token, const std::string& ending,
               std::string bytes, bool is_video) {
  if (!is_video) files["media/" + token + ".js"] = as_script(token, bytes);
  files["media/" + token + ending] = std::move(bytes);
}

ZipFiles page_files(const fs::path& pages, bool is_turned) {
  ZipFiles files;
  for (const char* name : {"LICENSES.txt", "index.html", "questionnaire.css", "questionnaire.js"})
    files[name] = read_file(pages / name);
  if (is_turned) files["turn_view.js"] = read_file(pages / "turn_view.js");
  return files;
}

}  // namespace

ordered_json dataset_description(const Manifest& manifest) {
  ordered_json variables = ordered_json::array();
  for (const Column& column : answer_form.columns)
    variables.push_back(psych_ds_variable(column.name, column.meaning, column.unit));
  for (const char* name : {"consented_at", "finished", "ended", "screening_fault", "language",
                           "consent_version", "consent_sha256"})
    variables.push_back(psych_ds_variable(name, find_column(participant_form, name)->meaning));
  if (questionnaire_of(manifest).screening.sound) {
    variables.push_back(
        psych_ds_variable("tones_1", "number of tones that the participant counted"));
    variables.push_back(
        psych_ds_variable("tones_2", "the same at the second attempt, after a wrong count"));
  }
  for (const ScreeningQuestion& question : questionnaire_of(manifest).screening.questions)
    variables.push_back(psych_ds_variable(question.id, question.ask.text));
  for (const Demographic& question : questionnaire_of(manifest).demographics)
    variables.push_back(psych_ds_variable(question.id, question.ask.text));
  const Recruitment& recruitment = questionnaire_of(manifest).recruitment;
  for (const std::string& name : kept_parameters(recruitment))
    variables.push_back(psych_ds_variable(
        parameter_column(name), fmt::format("{} of the URL parameter {} of the participant's link",
                                            recruitment.pseudonymise ? "hash" : "value", name)));
  return psych_ds_description(title_of(manifest),
                              fmt::format("Answers to the questionnaire of study {}: one row per "
                                          "answer, and one row per participant.",
                                          manifest.study),
                              variables);
}

std::string answers_readme() {
  return "# Answers\n\n"
         "Put the files saved by the participants' browsers here, unchanged: for each session\n"
         "one file of answers and one about the participant. ../dataset_description.json "
         "documents\n"
         "their columns.\n";
}

/// What the experimenter enters at the recruitment service; empty if there is none.
std::string recruitment_readme(const Recruitment& recruitment) {
  const std::vector<std::string> kept = kept_parameters(recruitment);
  if (recruitment == Recruitment()) return "";
  std::string text =
      "Recruited participants\n"
      "    Use JATOS, or mien study serve: a page on a web server saves the answers on the\n"
      "    participant's computer.\n";
  if (recruitment.prolific != SessionEndTexts())
    text +=
        "    At Prolific, enter the address of the study followed by\n"
        "        "
        "?PROLIFIC_PID={{%PROLIFIC_PID%}}&STUDY_ID={{%STUDY_ID%}}&SESSION_ID={{%SESSION_ID%}}\n";
  text += fmt::format("    Kept of the participant's link{}: {}.\n",
                      recruitment.pseudonymise ? ", as hashes" : "",
                      kept.empty() ? "nothing" : fmt::format("{}", fmt::join(kept, ", ")));
  for (const auto& [word, end] : session_end_words)
    if (const std::string address = address_after(recruitment, end); !address.empty())
      text += fmt::format("    {:<17} {}\n", std::string(word) + ":", address);
  return text + "    experiment.js shows these addresses and codes to those who read scripts.\n\n";
}

std::string export_readme(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  const std::string& first = plans.front().participant;
  const std::string& last = plans.back().participant;
  std::string text = fmt::format(
      "{}\n"
      "{}\n\n"
      "Questionnaire of study {}: {} participant{} ({} to {}), expected to take {} each.\n"
      "No network is needed and no data are sent.\n\n",
      title_of(manifest), std::string(title_of(manifest).size(), '='), manifest.study, plans.size(),
      plans.size() == 1 ? "" : "s", first, last, duration_text(plans));
  text += fmt::format(
      "On this computer\n"
      "    Open index.html in a browser (double-click it). At the end the browser downloads three\n"
      "    files: answers and participant (CSV), and the complete record (JSON). Participants\n"
      "    resume after reloading.\n\n"
      "    The browser assigns one of the plans it has used least often. To choose a plan:\n"
      "        index.html?participant={}\n\n"
      "    index.html?experimenter shows you what this browser keeps: answers, to save again, and\n"
      "    who was screened out or has withdrawn. These see their last page again until you press\n"
      "    \"Start for the next participant\" there; \"Forget everything\" is for trial runs.\n\n"
      "On a web server\n"
      "    Upload index.html, questionnaire.js, questionnaire.css, experiment.js{} and media/.\n"
      "    The files are saved on the participant's computer; the last page lists them and asks\n"
      "    to send them to you. Say how in the ending of the manifest. experiment.js reveals\n"
      "    which video is which to those who read scripts; mien study serve does not, and collects "
      "the\n"
      "    answers.\n\n"
      "On JATOS\n"
      "    Import {}.jzip (Studies, +, Import). Each participant of a batch gets one of the plans\n"
      "    used least often in it; ?participant={} in the link chooses a plan. The result data "
      "are\n"
      "    the CSV of the answers, complete after every answer; the result files hold the "
      "rest.\n\n",
      first, questionnaire.view == ShownAs::turn ? ", turn_view.js" : "", manifest.study, first);
  if (questionnaire.phones == Phones::refused)
    text += "Participants on phones are turned away with a message, as set in the manifest.\n\n";
  if (!questionnaire.screening.quotas.empty())
    text +=
        "The quotas of the manifest hold only with mien study serve, which knows all sessions.\n\n";
  text += recruitment_readme(questionnaire.recruitment);
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

ZipFiles exported_questionnaire(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                                const MediaFiles& media, const fs::path& pages) {
  const ordered_json experiment = experiment_json(manifest, plans, media);
  ZipFiles files = page_files(pages, questionnaire_of(manifest).view == ShownAs::turn);
  files["experiment.js"] = "globalThis.mienExperiment = " + experiment.dump() + ";\n";
  for (const auto& [stimulus, file] : media) {
    add_media(files, file.token, file.ending, read_file(file.file),
              file.type.starts_with("video/"));
    for (const FigureFile& figure : file.figures)
      if (!files.contains("media/" + figure.token + ".glb"))
        add_media(files, figure.token, ".glb", read_file(figure.file), false);
  }
  // JATOS gets only the files that participants need.
  ZipFiles assets = files;
  assets["index.html"] = jatos_page(std::move(assets["index.html"]), "questionnaire.js");
  const std::string title = title_of(manifest);
  files[manifest.study + ".jzip"] =
      jatos_archive({.title = title,
                     .description = fmt::format("Questionnaire of study {}, {} participants",
                                                manifest.study, plans.size()),
                     .folder = manifest.study,
                     .key = fmt::format("{}/{}", manifest.study, manifest.seed)},
                    assets);
  files["experiment.json"] = experiment.dump(1) + "\n";
  files["plans.csv"] = plans_csv(plans);
  files["answers/dataset_description.json"] = dataset_description(manifest).dump(2) + "\n";
  files["answers/data/README.md"] = answers_readme();
  files["README.txt"] = export_readme(manifest, plans);
  return files;
}

void refuse_foreign_folder(const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Error({folder.string()}, "is not a folder",
                "name a folder for the questionnaire with -o");
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / export_marker))
    throw Error({folder.string()}, "exists, but was not written by mien study export",
                "name a new folder with -o");
}

void refuse_answers_to_other_design(const fs::path& folder, const std::string& design) {
  const fs::path answers = folder / "answers/data", before = folder / "experiment.json";
  if (!fs::is_directory(answers) || !fs::is_regular_file(before)) return;
  const auto is_added = [](const fs::directory_entry& entry) {
    return entry.path().filename() != "README.md";
  };
  if (std::ranges::none_of(fs::directory_iterator(answers), is_added)) return;
  const ordered_json experiment = ordered_json::parse(read_file(before), nullptr, false);
  if (experiment.is_object() && experiment.value("design", "") == design) return;
  throw Error({answers.string()},
              "holds answers to a different questionnaire: texts, plans or participants have "
              "changed since the last export",
              "name a new folder with -o");
}

void write_export(const ZipFiles& files, const fs::path& folder) {
  refuse_foreign_folder(folder);
  for (const auto& [path, bytes] : files) motion::inside(folder, path, {folder.string()});
  motion::inside(folder, export_marker, {folder.string()});
  make_folder(folder);
  std::set<std::string> ours;
  if (fs::exists(folder / export_marker)) {
    std::istringstream lines(read_file(folder / export_marker));
    for (std::string line; std::getline(lines, line);) ours.insert(line);
  }
  const auto put_mark = [&] {
    std::string mark;
    for (const std::string& path : ours) mark += path + "\n";
    write_file(folder / export_marker, mark);
  };
  // If this is interrupted, the list covers the files of both exports.
  for (const auto& [path, bytes] : files) ours.insert(path);
  put_mark();
  for (const std::string& path : ours)
    if (!files.contains(path) && motion::is_inside(folder, path)) fs::remove(folder / path);
  for (const auto& [path, bytes] : files) {
    make_folder((folder / path).parent_path());
    write_file(folder / path, bytes);
  }
  std::erase_if(ours, [&](const std::string& path) { return !files.contains(path); });
  put_mark();
}

}  // namespace mien::pipeline
