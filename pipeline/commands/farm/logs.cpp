#include <memory>
#include <set>

#include <CLI/CLI.hpp>

#include "motion/error.h"
#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/element_logs.h"
#include "pipeline/farm/worker_reports.h"

namespace mien::pipeline {

namespace {

struct LogsCommand {
  FarmArguments study;
  std::string item;
  int lines = 20;
};

/// Of what failed: by the workers' own word, or by how jobs ended. Each file once.
std::vector<ElementLog> logs_of_failed(const std::filesystem::path& folder) {
  std::vector<ElementLog> logs;
  std::set<std::filesystem::path> seen;
  const auto add = [&](const std::vector<ElementLog>& more) {
    for (const ElementLog& log : more) {
      if (seen.insert(log.file).second) logs.push_back(log);
    }
  };
  for (const FailedItem& failed : failed_items(folder)) add(logs_of(failed.item, folder));
  add(logs_of_ended(folder));
  return logs;
}

int show_logs(const LogsCommand& command, const Console& console) {
  const FarmStudy study(command.study, console);
  std::vector<ElementLog> logs;
  if (command.item.empty()) {
    logs = logs_of_failed(study.folder);
    if (logs.empty()) console.out << study.folder.string() << ": no log of a failure\n";
  } else {
    logs = logs_of(command.item, study.folder);
    if (logs.empty()) {
      throw Error("no job that was to make " + command.item + " has written a log",
                  "mien plan lists the tasks of a study, mien farm status what waits");
    }
  }
  for (const ElementLog& log : logs) {
    console.out << "==> " << log.item << ": " << log.file.string() << '\n'
                << tail_of(log.file, command.lines);
  }
  return exit_done;
}

}  // namespace

void add_farm_logs_command(CLI::App& farm, Command& chosen) {
  CLI::App* command = farm.add_subcommand("logs", "The last lines that jobs wrote: of what failed");
  const auto options = std::make_shared<LogsCommand>();
  add_farm_arguments(*command, options->study);
  command->add_option("item", options->item, "Of this item instead: film:walk, or film:walk[3/12]");
  command->add_option("--lines,-n", options->lines, "How many lines of each")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->footer("\nExamples:\n  mien farm logs my.yaml\n  mien farm logs my.yaml film:target-1");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return show_logs(*options, console); };
  });
}

}  // namespace mien::pipeline
