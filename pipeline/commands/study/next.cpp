#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/base/drawing/plot_file.h"
#include "pipeline/commands/study/answer_inputs.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/next_command.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/production/methods/references.h"
#include "pipeline/study/adaptive/film_map.h"
#include "pipeline/study/adaptive/film_report.h"
#include "pipeline/study/adaptive/film_rounds.h"
#include "pipeline/study/adaptive/film_space.h"
#include "pipeline/study/adaptive/film_tables.h"
#include "pipeline/study/adaptive/next_films.h"
#include "pipeline/study/adaptive/pair_study.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A bound for memory and time, which grow with its square.
constexpr int most_candidates = 2000;
constexpr int usual_candidates = 600;

std::vector<Answers> answers_of(const std::vector<fs::path>& files, const Manifest& manifest,
                                const Console& console) {
  std::vector<Answers> rounds;
  for (const fs::path& file : distinct_files(files, console)) {
    rounds.push_back(read_answers(file, questionnaire_scales(manifest)));
    for (const std::string& warning : rounds.back().warnings)
      console.err << "warning: " << file.string() << ": " << warning << '\n';
  }
  return rounds;
}

/// Names stimuli that the last questionnaire asks about and nobody has answered: their round may
/// have been forgotten, and its films would be proposed again.
void note_unanswered(const Manifest& manifest, const std::vector<Answers>& rounds,
                     const Console& console) {
  std::set<std::string> answered;
  for (const Answers& round : rounds)
    for (const Answer& answer : round.answers) answered.insert(answer.stimulus);
  std::vector<std::string> without;
  for (const std::string& id : questionnaire_stimuli(manifest))
    if (!answered.contains(id)) without.push_back(id);
  if (!without.empty())
    console.err << fmt::format(
        "note: there are no answers about {}; if this round was rated, give its answers, too\n",
        fmt::join(without, ", "));
}

/// Throws Error for an option that needs ratings.
void refuse_what_needs_ratings(const NextCommand& command) {
  const auto refuse = [](bool is_given, const char* name) {
    if (is_given)
      throw Error(fmt::format("{} needs ratings, and no answers were given", name),
                  "give the CSV that the questionnaire wrote, or omit the option to choose the "
                  "films of the first round");
  };
  refuse(!command.highest.empty(), "--highest");
  refuse(!command.lowest.empty(), "--lowest");
  refuse(!command.scales.empty(), "--scales");
  refuse(!command.tables.empty(), "--tables");
  refuse(!command.show.empty(), "--show");
}

/// The paragraph and its references, if they are wanted.
std::vector<std::pair<fs::path, std::string>> methods_files(const NextCommand& command,
                                                            const RoundMethods& methods) {
  if (command.methods.empty()) return {};
  const fs::path text = command.methods;
  return {{text, methods.text + '\n'},
          {fs::path(text).replace_extension(".bib"), bibtex_of(methods.cited)}};
}

std::string comment_of(const NextCommand& command, const FilmChoice& choice, std::uint64_t seed) {
  if (choice.rated.scales.empty())
    return fmt::format(
        "# The first round of films, chosen by their features by mien study next with seed {}.\n",
        seed);
  return fmt::format("# The next round of films, {}, chosen by mien study next with seed {}{}.\n",
                     aim_text(aim_of(command)), seed,
                     choice.rated.simulated ? " from simulated answers" : "");
}

/// What can be made, what is known of it and what is to be made next.
FilmChoice film_choice(const NextCommand& command, const Manifest& manifest,
                       const std::vector<Answers>& rounds, std::uint64_t seed) {
  const Repertoire repertoire = load_repertoire(manifest);
  if (repertoire.names.size() > most_candidates)
    throw Error(fmt::format("the study has {} examples, and films are chosen among {} at most",
                            repertoire.names.size(), most_candidates),
                "name fewer examples");
  FilmChoice choice;
  choice.space = film_space(repertoire, command.features);
  choice.aim = aim_of(command);
  const auto films = static_cast<std::size_t>(command.films.value_or(usual_next_count));
  if (rounds.empty())
    choice.rated.answers_per_film = static_cast<int>(planned_answers(manifest, films));
  else
    choice.rated =
        rated_study(manifest, repertoire, choice.space, rounds, asked_scales(command, manifest));
  choice.candidates = film_candidates(
      choice.space.places, static_cast<std::size_t>(command.candidates.value_or(usual_candidates)),
      manifest.examples.blendable, seed);
  choice.next =
      next_films(choice.candidates, choice.rated.scales,
                 {.films = films,
                  .aim = choice.aim,
                  .answers = choice.rated.answers_per_film,
                  .planned = unanswered_rounds(manifest, repertoire, choice.space, rounds)});
  choice.rounds = film_rounds(choice.candidates, choice.rated.scales);
  return choice;
}

/// Throws Error if the folder of a file that is to be written does not exist, before anything is
/// chosen or written.
void require_folder_of(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty() && !fs::is_directory(folder))
    throw Error({file}, "its folder does not exist", "create it first");
}

int choose_next(const NextCommand& command, const Console& console) {
  for (const std::string& file : {command.out, command.show, command.methods})
    require_folder_of(file);
  if (!command.show.empty()) require_plot_file(command.show);
  if (!command.methods.empty() && fs::path(command.methods).extension() != ".md")
    throw Error({command.methods}, "is no name for a text", "let it end in .md");
  const AnswerInputs inputs = inputs_with_or_without_answers(command.files);
  const Manifest manifest = questionnaire_manifest(inputs.manifest.string(), console);
  const bool has_pairs = questionnaire_of(manifest).trials == &pair_form;
  if (inputs.answers.empty()) {
    refuse_what_needs_ratings(command);
    if (has_pairs || command.pairs) throw no_answers();
  }
  if (has_pairs || command.pairs) return choose_next_pairs(command, inputs, manifest, console);
  return choose_next_films(command, inputs, manifest, console);
}

}  // namespace

FilmAim aim_of(const NextCommand& command) {
  if (!command.highest.empty()) return {.scale = command.highest, .highest = true};
  return {.scale = command.lowest, .highest = false};
}

std::vector<std::string> asked_scales(const NextCommand& command, const Manifest& manifest) {
  std::vector<std::string> asked;
  for (const Scale& scale : questionnaire_scales(manifest).scales) asked.push_back(scale.id);
  for (const std::vector<std::string>& wanted :
       {command.scales, std::vector<std::string>{aim_of(command).scale}})
    for (const std::string& scale : wanted)
      if (!scale.empty() && std::ranges::find(asked, scale) == asked.end())
        throw Error(fmt::format("the questionnaire has no scale {}", motion::in_quotes(scale)),
                    fmt::format("name one of {}", fmt::join(asked, ", ")));
  if (command.scales.empty()) return asked;
  std::vector<std::string> wanted = command.scales;
  const std::string aim = aim_of(command).scale;
  if (!aim.empty() && std::ranges::find(wanted, aim) == wanted.end()) wanted.push_back(aim);
  return wanted;
}

std::vector<fs::path> distinct_files(const std::vector<fs::path>& files, const Console& console) {
  std::vector<fs::path> distinct;
  std::map<std::string, fs::path> known;
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file))
      throw Error({file.string()}, "there is no such file", "check the name of the answers");
    const auto [same, is_new] = known.emplace(read_file(file), file);
    if (is_new)
      distinct.push_back(file);
    else
      console.err << fmt::format("note: {} has the same content as {} and was left out\n",
                                 file.string(), same->second.string());
  }
  return distinct;
}

std::string next_name(const NextCommand& command, const Manifest& manifest, bool is_first) {
  if (!command.name.empty()) return command.name;
  return is_first ? name_of_first_round(manifest.study) : name_of_next_round(manifest.study);
}

std::string checked_next_yaml(const NextCommand& command, const Manifest& round,
                              const std::string& comment) {
  const fs::path file = command.out;
  std::string yaml = comment + manifest_yaml(round, file.parent_path());
  const ManifestReading reading = check_manifest_text(yaml, file, process_environment());
  if (!reading.faults.empty()) throw Faults(reading.faults);
  refuse_other_content(file, yaml);
  return yaml;
}

void write_next_tables(const NextCommand& command, const std::vector<WrittenTable>& tables,
                       const Console& console) {
  if (command.tables.empty()) return;
  write_tables(command.tables, tables);
  for (const WrittenTable& table : tables)
    console.out << (fs::path(command.tables) / table.form.path).string() << '\n';
}

void refuse_other_methods(const NextCommand& command, const RoundMethods& methods) {
  for (const auto& [file, content] : methods_files(command, methods))
    refuse_other_content(file, content);
}

void write_next_methods(const NextCommand& command, const RoundMethods& methods,
                        const Console& console) {
  for (const auto& [file, content] : methods_files(command, methods)) {
    write_file(file, content);
    console.out << file.string() << '\n';
  }
}

int choose_next_films(const NextCommand& command, const AnswerInputs& inputs,
                      const Manifest& manifest, const Console& console) {
  const std::vector<Answers> rounds = answers_of(inputs.answers, manifest, console);
  const bool is_first = rounds.empty();
  if (!is_first) note_unanswered(manifest, rounds, console);
  const std::uint64_t seed = command.seed.value_or(manifest.seed);
  FilmChoice choice = film_choice(command, manifest, rounds, seed);
  for (const std::string& sentence : choice.rated.left_out)
    console.err << "note: " << sentence << '\n';
  const Manifest round = next_round(manifest, choice.space, choice.candidates, choice.next,
                                    next_name(command, manifest, is_first), is_first ? 1 : 2);
  choice.ids = round.questionnaire->stimuli.ids;
  const std::string yaml = checked_next_yaml(command, round, comment_of(command, choice, seed));
  refuse_other_methods(command, film_methods(choice));
  console.out << film_report(choice);
  if (const auto wanted = static_cast<std::size_t>(command.films.value_or(usual_next_count));
      choice.next.films.size() < wanted)
    console.err << fmt::format(
        "note: {} films were asked for; all others differ by less than 0.3 standard deviations "
        "from "
        "those that are rated, planned or chosen\n",
        wanted);
  write_file(command.out, yaml);
  console.out << command.out << '\n';
  write_next_tables(command, film_tables(choice), console);
  write_next_methods(command, film_methods(choice), console);
  if (command.show.empty()) return exit_done;
  write_file(command.show, plot_for_file(film_map_plot(choice), command.show));
  console.out << command.show << '\n';
  return exit_done;
}

Command study_next_command() {
  const auto options = std::make_shared<NextCommand>();
  return {
      .name = "next",
      .summary =
          "Choose the films to rate, or the pairs to compare, in the next round from the answers "
          "so far",
      .options =
          {argument("files", &options->files,
                    "Answers (CSV, or folders of answers) of all rounds, and the manifest of the "
                    "last one; the manifest alone for the films of the first round"),
           option("-o,--output", &options->out, "Manifest (YAML) of the next round to write")
               .required(),
           option("--films", &options->films, "Number of films, for questionnaires of ratings")
               .between(1, 200)
               .with_default(std::to_string(usual_next_count)),
           option("--pairs", &options->pairs, "Number of pairs, for questionnaires of pairs")
               .between(1, 1000)
               .with_default(std::to_string(usual_next_count))
               .excludes("--films"),
           option("--highest", &options->highest,
                  "Choose films that may be rated highest on this scale (default: films that tell "
                  "the most about all scales)"),
           option("--lowest", &options->lowest,
                  "Choose films that may be rated lowest on this scale")
               .excludes("--highest"),
           option("--scales", &options->scales,
                  "Scales that count, separated by commas (default: all that are asked)")
               .with_commas(),
           option("--features", &options->features,
                  "Motion features that distinguish films, separated by commas (default: "
                  "the four groups)")
               .with_commas(),
           option("--candidates", &options->candidates,
                  "Number of blends of the examples among which films are chosen")
               .between(10, most_candidates)
               .with_default(std::to_string(usual_candidates)),
           option("--seed", &options->seed, "Seed of the blends; default: as in the manifest"),
           option("--study", &options->name,
                  "Name of the next study (default: this one's, numbered)"),
           option("--tables", &options->tables,
                  "Folder for tables: next_films.csv and known_films.csv (what is expected of the "
                  "films, and of all that can be made) and rounds.csv (what each round has "
                  "brought); of pairs, next_pairs.csv and known_worths.csv"),
           option(
               "--methods", &options->methods,
               "File (.md) for a paragraph of the methods section that says how they were chosen; "
               "its references (.bib) are written beside it"),
           option("--show", &options->show,
                  "Figure (.png, .svg or .pdf) that maps what is known: expected ratings and their "
                  "standard deviations over all films that can be made")},
      .notes =
          "Ratings are taken to be a smooth function of the motion features of a film (a Gaussian "
          "process), and\nfilms are blends of two or three examples. The written manifest has all "
          "earlier stimuli, so that the answers\nof all rounds can be given together, and its "
          "questionnaire shows the new ones.\n"
          "Without answers, the films of the first round are chosen: those that tell the most "
          "where\n"
          "nothing is known yet.\n"
          "In a questionnaire of pairs, the next pairs are those whose answers tell the most about "
          "the worths of the\nstimuli (model of Bradley and Terry).\n\n"
          "Examples:\n"
          "  mien study next study.yaml -o study-1.yaml --films 8\n"
          "  mien study next answers.csv study.yaml -o study-2.yaml\n"
          "  mien study next answers.csv answers-2.csv study-2.yaml -o study-3.yaml --highest "
          "sad-happy --films 6 \\\n"
          "    --show known.png\n"
          "  mien study next choices.csv pairs.yaml -o pairs-2.yaml --pairs 20",
      .run = [options](const Console& console) { return choose_next(*options, console); }};
}

}  // namespace mien::pipeline
