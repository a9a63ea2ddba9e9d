#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/answer_inputs.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/study/adaptive/film_space.h"
#include "pipeline/study/adaptive/film_tables.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A bound for memory and time, which grow with its square.
constexpr int most_candidates = 2000;

struct NextCommand {
  std::vector<std::string> files;  ///< answers, and the manifest
  std::string out;
  int films = 12;
  int candidates = 600;
  std::string highest, lowest;
  std::vector<std::string> scales, features;
  std::optional<std::uint64_t> seed;
  std::string name;
  std::string tables;
};

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

/// Reads a file that is given twice, or was saved twice, once.
std::vector<Answers> answers_of(const std::vector<fs::path>& files, const Manifest& manifest,
                                const Console& console) {
  std::vector<Answers> rounds;
  std::map<std::string, fs::path> known;
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file))
      throw Error({file.string()}, "there is no such file", "check the name of the answers");
    const auto [same, is_new] = known.emplace(read_file(file), file);
    if (!is_new) {
      console.err << fmt::format("note: {} has the same content as {} and was left out\n",
                                 file.string(), same->second.string());
      continue;
    }
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

std::string aim_text(const FilmAim& aim) {
  if (aim.scale.empty()) return "to learn the most about all ratings";
  return fmt::format("that may be rated {} on {}", aim.highest ? "highest" : "lowest", aim.scale);
}

/// What a film is chosen for: "sad-happy 1.33 ± 0.24", or "removes 13 % of what is unknown".
std::string reason(const FilmChoice& choice, const NextFilm& film) {
  if (choice.aim.scale.empty())
    return fmt::format("removes {:.1f} % of what is unknown", 100.0 * film.gain);
  const auto scale = std::ranges::find(choice.rated.scales, choice.aim.scale, &RatedFilms::scale);
  const auto s = static_cast<std::size_t>(scale - choice.rated.scales.begin());
  return fmt::format("{} {:.2f} ± {:.2f}", choice.aim.scale, film.mean[s], film.deviation[s]);
}

void show(const FilmChoice& choice, const Console& console) {
  if (choice.rated.simulated) console.out << "simulated answers\n";
  console.out << fmt::format("{} of {} films that the examples allow, {}\n",
                             choice.next.films.size(), choice.candidates.size(),
                             aim_text(choice.aim));
  for (std::size_t f = 0; f < choice.next.films.size(); ++f) {
    const NextFilm& film = choice.next.films[f];
    console.out << fmt::format("  {}  {:40} {}\n", choice.ids[f],
                               blend_text(choice, film.candidate), reason(choice, film));
  }
  console.out << "Standard deviation of expected mean ratings (root mean square over all films):\n"
              << fmt::format("  {:24} {:>6}  after this round\n", "", "now");
  for (std::size_t s = 0; s < choice.rated.scales.size(); ++s)
    console.out << fmt::format("  {:24} {:6.2f} {:6.2f}\n", choice.rated.scales[s].scale,
                               choice.next.known_now[s], choice.next.known_then[s]);
}

std::string comment_of(const NextCommand& command, const FilmChoice& choice, std::uint64_t seed) {
  return fmt::format("# The next round of films, {}, chosen by mien study next with seed {}{}.\n",
                     aim_text(aim_of(command)), seed,
                     choice.rated.simulated ? " from simulated answers" : "");
}

/// The manifest's text. Throws Faults if the manifest would have some, as when the questionnaire
/// refers to levels of factors that the new films do not have.
std::string checked_yaml(const Manifest& round, const std::string& comment, const fs::path& file) {
  std::string yaml = comment + manifest_yaml(round, file.parent_path());
  const ManifestReading reading = check_manifest_text(yaml, file, process_environment());
  if (!reading.faults.empty()) throw Faults(reading.faults);
  return yaml;
}

int choose_next(const NextCommand& command, const Console& console) {
  const AnswerInputs inputs = answer_inputs(command.files);
  const Manifest manifest = questionnaire_manifest(inputs.manifest.string(), console);
  const std::vector<std::string> asked = asked_scales(command, manifest);
  const std::vector<Answers> rounds = answers_of(inputs.answers, manifest, console);
  note_unanswered(manifest, rounds, console);
  const Repertoire repertoire = load_repertoire(manifest);
  const std::uint64_t seed = command.seed.value_or(manifest.seed);
  if (repertoire.names.size() > most_candidates)
    throw Error(fmt::format("the study has {} examples, and films are chosen among {} at most",
                            repertoire.names.size(), most_candidates),
                "name fewer examples");
  FilmChoice choice;
  choice.space = film_space(repertoire, command.features);
  choice.aim = aim_of(command);
  choice.rated = rated_study(manifest, repertoire, choice.space, rounds, asked);
  for (const std::string& sentence : choice.rated.left_out)
    console.err << "note: " << sentence << '\n';
  choice.candidates =
      film_candidates(choice.space.places, static_cast<std::size_t>(command.candidates),
                      manifest.examples.blendable, seed);
  choice.next = next_films(choice.candidates, choice.rated.scales,
                           {.films = static_cast<std::size_t>(command.films),
                            .aim = choice.aim,
                            .answers = choice.rated.answers_per_film});
  const Manifest round =
      next_round(manifest, choice.space, choice.candidates, choice.next,
                 command.name.empty() ? name_of_next_round(manifest.study) : command.name);
  choice.ids = round.questionnaire->stimuli.ids;
  const fs::path out = command.out;
  const std::string yaml = checked_yaml(round, comment_of(command, choice, seed), out);
  refuse_other_content(out, yaml);
  show(choice, console);
  write_file(out, yaml);
  console.out << out.string() << '\n';
  if (command.tables.empty()) return exit_done;
  const std::vector<WrittenTable> tables = film_tables(choice);
  write_tables(command.tables, tables);
  for (const WrittenTable& table : tables)
    console.out << (fs::path(command.tables) / table.form.path).string() << '\n';
  return exit_done;
}

}  // namespace

Command study_next_command() {
  const auto options = std::make_shared<NextCommand>();
  return {
      .name = "next",
      .summary = "Choose the films of the next round of ratings from the answers so far",
      .options =
          {argument("files", &options->files,
                    "Answers (CSV, or folders of answers) of all rounds, and the manifest of the "
                    "last one"),
           option("-o,--output", &options->out, "Manifest (YAML) of the next round to write")
               .required(),
           option("--films", &options->films, "Number of films").between(1, 200).with_default(),
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
               .with_default(),
           option("--seed", &options->seed, "Seed of the blends; default: as in the manifest"),
           option("--study", &options->name,
                  "Name of the next study (default: this one's, numbered)"),
           option("--tables", &options->tables,
                  "Folder for next_films.csv and known_films.csv: what is expected of the films, "
                  "and of all that can be made")},
      .notes =
          "Ratings are taken to be a smooth function of the motion features of a film (a Gaussian "
          "process), and\nfilms are blends of two or three examples. The written manifest has all "
          "earlier stimuli, so that the answers\nof all rounds can be given together, and its "
          "questionnaire shows the new ones.\n\n"
          "Examples:\n"
          "  mien study next answers.csv study.yaml -o study-2.yaml\n"
          "  mien study next answers.csv answers-2.csv study-2.yaml -o study-3.yaml --highest "
          "sad-happy --films 6",
      .run = [options](const Console& console) { return choose_next(*options, console); }};
}

}  // namespace mien::pipeline
