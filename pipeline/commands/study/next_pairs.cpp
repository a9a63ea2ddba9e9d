#include <map>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/next_command.h"
#include "pipeline/study/adaptive/pair_study.h"
#include "pipeline/study/adaptive/pair_tables.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Throws Error for an option that is about films.
void refuse_film_options(const NextCommand& command) {
  const auto refuse = [](bool is_given, const char* name) {
    if (is_given)
      throw Error(fmt::format("{} is about ratings, and the questionnaire has pairs", name),
                  "omit it");
  };
  refuse(command.films.has_value(), "--films");
  refuse(command.candidates.has_value(), "--candidates");
  refuse(command.seed.has_value(), "--seed");
  refuse(!command.highest.empty(), "--highest");
  refuse(!command.lowest.empty(), "--lowest");
  refuse(!command.features.empty(), "--features");
  refuse(!command.show.empty(), "--show");
}

/// The rows of each round: files with answers of the same design are of one round.
std::vector<std::vector<AnswerRow>> rounds_of_files(const std::vector<fs::path>& files,
                                                    const Console& console) {
  std::vector<std::vector<fs::path>> rounds;
  std::map<std::string, std::size_t> round_of;
  for (const fs::path& file : files) {
    const std::string design = answers_of_files({file}).rows.front().design;
    const auto [round, is_new] = round_of.emplace(design, rounds.size());
    if (is_new) rounds.emplace_back();
    rounds[round->second].push_back(file);
  }
  std::vector<std::vector<AnswerRow>> rows;
  for (const std::vector<fs::path>& round : rounds) {
    AnswersOfFiles answers = answers_of_files(round);
    print_warnings(answers.warnings, console);
    for (const std::string& note : answers.notes) console.err << "note: " << note << '\n';
    rows.push_back(std::move(answers.rows));
  }
  return rows;
}

std::string pair_comment(const PairStudy& study) {
  return fmt::format(
      "# The next round of pairs, those that tell the most about the worths of the stimuli, chosen "
      "by mien study next{}.\n",
      study.simulated ? " from simulated answers" : "");
}

}  // namespace

int choose_next_pairs(const NextCommand& command, const AnswerInputs& inputs,
                      const Manifest& manifest, const Console& console) {
  refuse_film_options(command);
  const std::vector<std::string> asked = asked_scales(command, manifest);
  const auto rounds = rounds_of_files(distinct_files(inputs.answers, console), console);
  PairChoice choice{.study = pair_study(manifest, rounds, asked), .next = {}};
  for (const std::string& note : choice.study.notes) console.err << "note: " << note << '\n';
  const auto wanted = static_cast<std::size_t>(command.pairs.value_or(usual_next_count));
  const std::size_t count = std::min(wanted, choice.study.pairs.size());
  choice.next = next_pairs(choice.study.pairs, choice.study.items, choice.study.stimuli.size(),
                           {.pairs = count, .answers = planned_answers(manifest, count)});
  const Manifest round =
      next_pair_round(manifest, choice.study, choice.next, next_name(command, manifest));
  const std::string yaml = checked_next_yaml(command, round, pair_comment(choice.study));
  refuse_other_methods(command, pair_methods(choice));
  console.out << pair_report(choice);
  write_file(command.out, yaml);
  console.out << command.out << '\n';
  write_next_tables(command, pair_tables(choice), console);
  write_next_methods(command, pair_methods(choice), console);
  return exit_done;
}

}  // namespace mien::pipeline
