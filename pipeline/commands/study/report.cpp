#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/answer_inputs.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/production/run/shown_moods.h"
#include "pipeline/production/run/video_seconds.h"
#include "pipeline/study/questionnaire/frozen_design.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/answer_files.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/report/results_report.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view leave_out = "leave-out";

struct ReportCommand {
  std::vector<std::string> files;  ///< answers, and the manifest
  std::vector<std::string> participants;
  std::string out;
  std::string correction;
  int max_failed_checks = -1;
  std::string unfinished = "keep";
  std::string frozen;
  std::string studies = "out";  ///< the folder of all studies
};

/// Compares the command line's choices for the analysis with the preregistered ones; those of the
/// manifest are compared elsewhere.
void compare_choices(const ReportCommand& options, const nlohmann::json& frozen,
                     std::vector<std::string>& differences) {
  const std::string correction = frozen.value("correction", "");
  if (!options.correction.empty() && options.correction != correction)
    differences.push_back(fmt::format("analysis: --correction {} instead of the registered {}",
                                      options.correction, correction));
  const int max_failed_checks = frozen.value("most_failed", 0);
  if (options.max_failed_checks >= 0 && options.max_failed_checks != max_failed_checks)
    differences.push_back(
        fmt::format("analysis: --max-failed-checks {} instead of the registered {}",
                    options.max_failed_checks, max_failed_checks));
  if (options.unfinished == leave_out)
    differences.emplace_back("analysis: --unfinished leave-out instead of the registered keep");
}

/// The difference of answers to a design that is not the registered one, or that is the same for
/// another number of participants.
std::string answers_of_other_design(const Manifest& manifest, const std::string& run,
                                    const std::string& registered, int participants) {
  const int planned = questionnaire_of(manifest).participants;
  Manifest as_registered = manifest;
  as_registered.questionnaire->participants = participants;
  const bool is_of_more = participants > 0 && participants != planned &&
                          run == design_hash(manifest, plan_sessions(manifest)) &&
                          registered == design_hash(as_registered, plan_sessions(as_registered));
  return is_of_more ? fmt::format(
                          "answers: given to the study as planned for {} participants "
                          "instead of the registered {}",
                          planned, participants)
                    : "answers: given to design " + run + ", which is not the registered one";
}

/// "Sessions of 2 of the 24 registered participants so far, 1 of them analysed."
std::string participants_so_far(const AnswerSet& answer_set, int registered) {
  const std::size_t met = answer_set.attention.size();
  const auto planned = static_cast<std::size_t>(std::max(registered, 0));
  const std::string of =
      met > planned ? fmt::format("{}, {} registered",
                                  counted_noun(met, "participant", "participants"), planned)
                    : fmt::format("{} of the {} registered participants{}", met, planned,
                                  met < planned ? " so far" : "");
  return fmt::format("Sessions of {}, {} of them analysed.", of, answer_set.people.size());
}

FrozenVerdict verdict_on(const ReportCommand& options, const Manifest& manifest,
                         const std::vector<AnswerRow>& rows, const AnswerSet& answer_set) {
  if (options.frozen.empty()) return {};
  const fs::path made = fs::path(options.studies) / manifest.study;
  FrozenVerdict verdict;
  verdict.differences =
      frozen_differences(options.frozen, manifest, fs::exists(made) ? made : fs::path());
  const std::string frozen = fs::path(options.frozen).filename().string();
  const std::string run = rows.front().design;  // collect_answers refuses others
  const auto design = nlohmann::json::parse(read_zip(options.frozen).at("design.json"));
  compare_choices(options, design.value("analysis", nlohmann::json::object()), verdict.differences);
  if (!run.empty() && run != design.value("design", ""))
    verdict.differences.push_back(answers_of_other_design(manifest, run, design.value("design", ""),
                                                          design.value("participants", 0)));
  const bool are_simulated = std::ranges::any_of(rows, &AnswerRow::simulated);
  verdict.sentence =
      verdict.differences.empty()
          ? fmt::format("No differences from the study registered in {}. {}{}", frozen,
                        are_simulated ? "The answers are simulated. " : "",
                        participants_so_far(answer_set, design.value("participants", 0)))
          : fmt::format("The study differs from the one registered in {}:", frozen);
  return verdict;
}

/// A sentence for each participant who is excluded, or flagged by quality rules.
std::vector<std::string> excluded_sentences(const Results& results) {
  if (!results.rule_counts.empty()) return flagged_sentences(results.answer_set);
  std::vector<std::string> sentences;
  for (const Attention& own : results.answer_set.attention)
    if (own.is_excluded)
      sentences.push_back(
          fmt::format("participant {} is excluded: {} of {} attention checks passed",
                      motion::in_quotes(own.participant), own.passed, own.checks));
  return sentences;
}

/// Prints how many answers and participants the rules flag, and what the analysis does with them.
/// The last of the counts is that of all rules.
void print_rule_counts(const AnswerSet& answer_set, const std::vector<RuleCount>& counts,
                       std::ostream& out) {
  const char* name =
      has_attention_checks(answer_set) ? "quality rules and attention checks" : "quality rules";
  std::ptrdiff_t rules = 0, excluding = 0;
  for (const RuleCount& count : std::span(counts).first(counts.size() - 1)) {
    if (count.rule == word_of(quality_rule_words, QualityRule::max_failed_checks)) continue;
    ++rules;
    excluding += count.is_excluded;
  }
  const RuleCount& all = counts.back();
  if (all.answers == 0 && all.participants == 0) {
    out << fmt::format("{} flag no answers and no participants\n", name);
    return;
  }
  out << fmt::format(
      "{} flag {} of {}: {}\n", name,
      counted_noun(static_cast<std::size_t>(all.answers), "answer", "answers"),
      counted_noun(static_cast<std::size_t>(all.participants), "participant", "participants"),
      excluding == rules ? "excluded"
      : excluding == 0   ? "included"
                         : "excluded or included, as the report states");
}

void print_results(const Results& results, const FrozenVerdict& frozen, const fs::path& folder,
                   const Console& console) {
  const AnswerSet& answer_set = results.answer_set;
  for (const std::string& note : answer_set.notes) console.err << note << '\n';
  for (const std::string& sentence : excluded_sentences(results)) console.err << sentence << '\n';
  if (answer_set.simulated) console.out << "simulated answers\n";
  for (const std::string& sentence : unfinished_sentences(answer_set))
    console.err << sentence << '\n';
  console.out << people_sentence(answer_set) << '\n';
  if (!results.rule_counts.empty()) print_rule_counts(answer_set, results.rule_counts, console.out);
  if (!frozen.sentence.empty()) console.out << frozen.sentence << '\n';
  for (const std::string& difference : frozen.differences)
    console.out << "  " << difference << '\n';
  console.out << (folder / "report.html").string() << '\n';
}

/// The largest number in names such as p007.
int max_participants(const std::vector<AnswerRow>& rows) {
  int most = 0;
  for (const AnswerRow& row : rows) {
    const std::string& name = row.participant;
    int number = 0;
    if (name.starts_with('p')) std::from_chars(name.data() + 1, name.data() + name.size(), number);
    most = std::max(most, number);
  }
  return most;
}

/// Notes if answers were given to another version of the questionnaire than the manifest's.
void note_other_design(const Manifest& manifest, const std::vector<AnswerRow>& rows,
                       AnswerSet& answer_set) {
  if (answer_set.design.empty()) return;
  const std::string now = design_hash(manifest, plan_sessions(manifest));
  if (answer_set.design == now) return;
  const int planned = questionnaire_of(manifest).participants;
  const int answered = max_participants(rows);
  Manifest other = manifest;
  other.questionnaire->participants = answered;
  const bool is_of_more =
      answered != planned && (answer_set.design == design_hash(other, plan_sessions(other)) ||
                              answer_set.design == design_hash(manifest, plan_sessions(other)));
  answer_set.notes.push_back(
      is_of_more
          ? fmt::format("The answers are of {} participants, but the manifest plans {}; everything "
                        "else is the same.",
                        answered, planned)
          : fmt::format("The answers were given to design {}; the manifest is now design {}.",
                        answer_set.design, now));
}

/// Which sessions are of the same person, if a quality rule asks for it.
SessionPeople people_of_sessions(const AnswerInputs& inputs, const Manifest& manifest) {
  const std::string& parameter = questionnaire_of(manifest).analysis.quality.repeated_by;
  if (parameter.empty()) return {};
  std::vector<CsvTable> answers, participants;
  for (const fs::path& file : inputs.answers) answers.push_back(read_csv(file));
  for (const fs::path& file : inputs.participants) participants.push_back(read_csv(file));
  return session_people(answers, participants, parameter);
}

/// Number of trials of each session plan.
std::map<std::uint64_t, int> planned_trials(const Manifest& manifest) {
  std::map<std::uint64_t, int> planned;
  // Tracks that end by their answers have no fixed number of trials.
  if (questionnaire_of(manifest).adaptive.may_end_early()) return planned;
  for (const SessionPlan& plan : plan_sessions(manifest))
    planned[plan.seed] = static_cast<int>(plan.trials.size());
  return planned;
}

/// Of continuous trials, the durations of the films and the moods of stimuli whose mood changes;
/// their motions are synthesized.
void add_films(const Manifest& manifest, ReportChoices& choices) {
  if (!questionnaire_of(manifest).trials->is_continuous) return;
  Motions motions(manifest);
  choices.film_seconds = video_seconds(manifest, motions);
  for (const std::string& id : shown_stimuli(manifest))
    if (const Stimulus* stimulus = motions.stimulus(id); stimulus != nullptr && stimulus->walk)
      choices.moods[id] = shown_moods(motions, *stimulus);
}

ReportChoices choices_of(const ReportCommand& options, const Manifest& manifest,
                         const ParticipantTable& people) {
  ReportChoices choices;
  choices.correction = meaning_of(correction_words, options.correction);
  if (options.max_failed_checks >= 0) choices.max_failed_checks = options.max_failed_checks;
  choices.planned = planned_trials(manifest);
  choices.finished = people.finished();
  choices.without_unfinished = options.unfinished == leave_out;
  add_films(manifest, choices);
  return choices;
}

int report(const ReportCommand& options, const Console& console) {
  const AnswerInputs inputs = answer_inputs(options.files, options.participants);
  const Manifest manifest = questionnaire_manifest(inputs.manifest.string(), console);
  const AnswersOfFiles answers = answers_of_files(inputs.answers);
  print_warnings(answers.warnings, console);
  const std::vector<AnswerRow>& rows = answers.rows;
  std::vector<ParticipantTable> tables;
  for (const fs::path& file : inputs.participants) tables.push_back(read_participants(file));
  ParticipantTable people = joined(tables);
  ReportChoices choices = choices_of(options, manifest, people);
  choices.session_people = people_of_sessions(inputs, manifest);
  AnswerSet answer_set = collect_answers(manifest, rows, choices);
  answer_set.notes.insert(answer_set.notes.begin(), answers.notes.begin(), answers.notes.end());
  note_other_design(manifest, rows, answer_set);
  const FrozenVerdict frozen = verdict_on(options, manifest, rows, answer_set);
  const Results results = results_of(std::move(answer_set), rows, std::move(people));
  const fs::path folder =
      options.out.empty() ? fs::path("out") / (manifest.study + "-results") : fs::path(options.out);
  clear_results_folder(folder);
  write_results(results, rows, frozen, folder);
  print_results(results, frozen, folder, console);
  return exit_done;
}

}  // namespace

Command study_report_command() {
  const auto options = std::make_shared<ReportCommand>();
  return {
      .name = "report",
      .summary = "Analyse a questionnaire's answers: tables, figures and a report on one page",
      .options =
          {argument("files", &options->files,
                    "Answers (CSV, or folders with answers.csv or saved *answers_data.csv) and the "
                    "manifest of the study, in either order"),
           option("-o,--output", &options->out, "Folder to write (default: out/<study>-results)"),
           option("--participants", &options->participants,
                  "Tables of participants (default: those beside the answers)"),
           option("--correction", &options->correction,
                  "Correction for multiple comparisons: holm, bh (Benjamini-Hochberg) or none "
                  "(default: as in the manifest)")
               .one_of({"holm", "bh", "none"}),
           option("--max-failed-checks", &options->max_failed_checks,
                  "Exclude participants who fail more attention checks than this (default: as in "
                  "the manifest)")
               .between(0, 1000)
               .formerly("--most-failed"),
           option("--unfinished", &options->unfinished,
                  "Participants who did not finish: keep (include their answers) or leave-out")
               .one_of({"keep", "leave-out"})
               .with_default(),
           option("--frozen", &options->frozen,
                  "Archive written by mien study design --freeze: report differences from it"),
           option("--studies", &options->studies,
                  "With --frozen: folder that contains the study's folder; the media in it are "
                  "compared, too")
               .formerly("--made")
               .with_default()},
      .notes =
          "Examples:\n"
          "  mien study report answers.csv study.yaml -o out/results\n"
          "  mien study report lab/ online/ study.yaml --correction bh --frozen design.zip",
      .run = [options](const Console& console) { return report(*options, console); }};
}

}  // namespace mien::pipeline
