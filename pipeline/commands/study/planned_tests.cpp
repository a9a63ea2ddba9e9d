#include "pipeline/commands/study/planned_tests.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/power/power_output.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Whole numbers in ascending order, without duplicates. Throws Error for others.
std::vector<int> whole_numbers(const std::vector<double>& given, const std::string& option) {
  std::vector<int> numbers;
  for (const double number : given) {
    if (number != std::floor(number))
      throw Error(fmt::format("{} takes whole numbers, not {:g}", option, number),
                  "for example " + option + " 2,4,8");
    numbers.push_back(static_cast<int>(number));
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Half, three quarters, all, one and a half times and twice the planned number.
std::vector<int> usual_participants(int planned) {
  std::vector<int> numbers;
  for (const double share : {0.5, 0.75, 1.0, 1.5, 2.0})
    numbers.push_back(std::max(4, static_cast<int>(std::lround(share * planned))));
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<fs::path> figure_files(const PlannedTestsCommand& command) {
  std::vector<fs::path> files;
  for (const char* ending : {".pdf", ".svg", ".png"})
    files.push_back(fs::path(command.table).replace_extension(ending));
  return files;
}

}  // namespace

std::vector<CommandOption> planned_tests_options(PlannedTestsCommand& options) {
  std::vector<CommandOption> all = {
      option(
          "--planned-tests", &options.table,
          "With --power: table (CSV) of the power of the tests that the analysis plan states, by "
          "simulated studies; a figure of the same name is saved beside it")
          .needs("--power")};
  const std::vector<CommandOption> more = that_need(
      "--planned-tests",
      {option("--truth", &options.truth,
              "With --planned-tests: CSV with columns stimulus, scale and value, the assumed true "
              "ratings (default: an effect of --difference in each test alone)"),
       option("--at-participants", &options.participants,
              "With --planned-tests: numbers of participants, such as 20,40,80 (default: 0.5 to 2 "
              "times the planned number)")
           .with_commas()
           .between(1.0, 10000.0),
       option("--at-stimuli", &options.stimuli,
              "With --planned-tests: numbers of stimuli per cell of the design, such as 2,4,8 "
              "(default: as in the manifest)")
           .with_commas()
           .between(0.0, 1000.0),
       option("--groups", &options.groups,
              "With --planned-tests: relative sizes of the groups of participants that are "
              "compared (default: two equal groups)")
           .with_commas()
           .between(0.0, 10000.0)});
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

PlannedTestsResult simulate_planned_tests(const PlannedTestsCommand& command,
                                          const PlannedPowerOptions& common,
                                          const Manifest& manifest, const Console& console) {
  const Questionnaire& asked = questionnaire_of(manifest);
  PlannedPowerOptions options = common;
  options.participants = command.participants.empty()
                             ? usual_participants(asked.participants)
                             : whole_numbers(command.participants, "--at-participants");
  if (options.participants.front() < 2)
    throw Error("a study of one participant cannot be tested", "--at-participants 10,20");
  options.stimuli_per_cell = whole_numbers(command.stimuli, "--at-stimuli");
  if (!command.groups.empty()) {
    if (asked.analysis.factorial.between.empty())
      throw Error("--groups states the sizes of groups, but the analysis plan compares none",
                  "omit --groups, or state questionnaire: analysis: {between: …}");
    const bool has_empty =
        std::ranges::any_of(command.groups, [](double size) { return size <= 0.0; });
    if (command.groups.size() < 2 || has_empty)
      throw Error("--groups takes the relative sizes of at least two groups, all above 0",
                  "for example --groups 0.5,0.4,0.1");
    options.groups = command.groups;
  }
  if (!command.truth.empty()) options.truth = read_truth(manifest, command.truth).ratings;
  ProgressBar bar(console.err, console.err_is_terminal);
  options.progress = [&](double share) {
    if (console.stop.stop_requested()) throw Interrupted();
    bar.show(share, "simulated studies");
  };
  PlannedTestsResult result;
  result.stated_participants =
      std::ranges::find(options.participants, asked.participants) == options.participants.end()
          ? options.participants.back()
          : asked.participants;
  result.assumptions = power_assumptions(manifest, options);
  result.rows = planned_power(manifest, options);
  return result;
}

void print_planned_tests(const PlannedTestsResult& result, double wanted_power,
                         const Manifest& manifest, std::ostream& out) {
  const double alpha = questionnaire_of(manifest).analysis.alpha;
  out << fmt::format("\nPower of the planned tests with {} participants, in percent:\n",
                     result.stated_participants);
  for (const std::string& sentence :
       planned_power_lines(result.rows, result.stated_participants, wanted_power, alpha))
    out << "  " << sentence << '\n';
  for (const std::string& sentence :
       planned_power_notes(result.rows, result.stated_participants, alpha))
    out << sentence << '\n';
  for (const std::string& sentence : result.assumptions) out << sentence << '\n';
}

void write_power_figure(const PlannedTestsCommand& command, const PlannedTestsResult& result,
                        double wanted_power, const Manifest& manifest, std::ostream& out) {
  const fs::path table = command.table;
  write_plot(power_chart(title_of(manifest), result.rows, wanted_power, result.assumptions),
             table.has_parent_path() ? table.parent_path() : fs::path("."), table.stem().string());
  for (const fs::path& file : figure_files(command)) out << file.string() << '\n';
}

void refuse_figure_loss(const PlannedTestsCommand& command) {
  if (fs::exists(command.table)) return;  // refuse_data_loss looks at it
  for (const fs::path& file : figure_files(command))
    if (fs::exists(file))
      throw Error({file.string()}, "exists already, without a table of power beside it",
                  "name another table");
}

}  // namespace mien::pipeline
