#include "pipeline/farm/worker.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "motion/text/shell_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/commands/farm/farm.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/farm/film_lengths.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/slurm/worker_codes.h"
#include "pipeline/farm/work_item.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/tasks/disk_fault.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// The fault is neither in the study nor transient: the job must not be repeated before a user has
/// looked at it.
class WrongSetup : public Error {
 public:
  using Error::Error;
};

struct WorkerArguments {
  ProductionArguments production;
  std::vector<std::string> tasks;
  std::string list;
  int line = 0;
  std::string expected;  ///< key of the graph that was submitted
};

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<std::string> items_in_line(const std::string& file, int line) {
  if (!std::ifstream(file))
    throw WrongSetup(file + ": cannot be read", "give a list of tasks written by mien farm submit");
  const std::vector<std::vector<std::string>> lines = lines_of_list(file);
  if (lines.size() < static_cast<std::size_t>(line))
    throw WrongSetup(
        fmt::format("{}: has {} lines, but line {} was requested", file, lines.size(), line),
        "check that the array was submitted with this list");
  return lines[static_cast<std::size_t>(line) - 1];
}

std::vector<std::string> items_of(const WorkerArguments& arguments, const Console& console) {
  std::vector<std::string> items;
  for (const std::string& text : arguments.tasks)
    for (std::string& word : split_words(text)) items.push_back(std::move(word));
  if (arguments.list.empty() && items.empty())
    throw WrongSetup("no tasks were given", "name tasks with --tasks, or --list and --line");
  if (arguments.list.empty()) return items;
  const std::vector<std::string> listed = items_in_line(arguments.list, arguments.line);
  items.insert(items.end(), listed.begin(), listed.end());
  if (listed.empty())
    console.err << fmt::format("note: {}:{}: the line is empty and is skipped\n", arguments.list,
                               arguments.line);
  return items;
}

/// Reports chunks without frames, because their film has fewer frames than chunks.
void print_empty_chunks(const std::vector<std::string>& items, const Production& production,
                        const fs::path& folder, const Console& console) {
  const auto has_chunk = [](const std::string& item) { return item.ends_with(']'); };
  if (std::none_of(items.begin(), items.end(), has_chunk)) return;
  const std::map<std::string, int> lengths = film_lengths(production, folder);
  for (const std::string& text : items) {
    const WorkItem item = work_item(text);
    const auto length = lengths.find(item.task);
    if (item.chunks == 0 || length == lengths.end()) continue;
    const auto [first, end] = range_of({item.chunk, item.chunks}, length->second);
    if (first < end) continue;
    console.err << fmt::format("note: {}: the film has {} frames, none of which is in this chunk\n",
                               text, length->second);
  }
}

void print_result(const WorkResult& result, const Console& console) {
  for (const std::string& repair : result.repairs) console.err << "note: " << repair << '\n';
  std::map<std::string, std::string> items_by_error;
  for (const FailedWork& failed : result.failed) {
    std::string& items = items_by_error[failed.error];
    items += (items.empty() ? "" : ", ") + failed.item;
  }
  for (const auto& [error, items] : items_by_error)
    console.err << error << "\n  (" << items << ")\n";
  for (const Nondeterminism& met : result.nondeterminism) console.err << to_string(met) << '\n';
  if (result.was_interrupted)
    console.err << "interrupted; finished work is kept, and the same command continues from here\n";
}

/// The command that reproduces an item, without options that differ between jobs.
std::string command_for(const WorkerArguments& arguments) {
  std::string command = "mien farm worker " + motion::shell_path(arguments.production.manifest);
  if (arguments.production.out != "out")
    command += " --out " + motion::shell_path(arguments.production.out);
  if (!arguments.production.quality.empty())
    command += " --quality " + arguments.production.quality;
  return command;
}

int make_items(const WorkerArguments& arguments, const Console& console) {
  const std::vector<std::string> items = items_of(arguments, console);
  if (items.empty()) return exit_done;
  const fs::path file = resolve_manifest(arguments.production.manifest, console);
  if (!fs::exists(file))
    throw WrongSetup(file.string() + ": does not exist",
                     "check that this machine has access to the shared folder");
  // Warnings of the manifest were printed when it was submitted.
  Production production(load_manifest(file, process_environment(), arguments.production.out),
                        options_of(arguments.production));
  const fs::path folder = folder_of(arguments.production, production.manifest());
  const Hash key = key_of(production.graph());
  if (!arguments.expected.empty() && arguments.expected != key)
    throw WrongSetup("this is not the study that was submitted (" + key + " instead of " +
                         arguments.expected + ")",
                     "the manifest, one of its files, the version of mien or the processor's "
                     "instruction set differs; mien farm resume submits the study as it is now");
  const TaskGraph graph = graph_of_items(production.graph(), items);
  WorkResult result;
  {
    Progress progress(console.err, console.err_is_terminal, graph, plan(graph, folder),
                      steady_seconds);
    result = work(graph, items, folder, jobs_of(arguments.production), console.stop,
                  progress.observer(), command_for(arguments));
  }
  print_result(result, console);
  print_empty_chunks(items, production, folder, console);
  return result.code();
}

int worker(const WorkerArguments& arguments, const Console& console) {
  try {
    return make_items(arguments, console);
  } catch (const WrongSetup& error) {
    console.err << error.what() << '\n';
    return worker_wrong_setup;
  } catch (const Error& error) {
    console.err << error.what() << '\n';
    return worker_bad_input;
  } catch (const DiskFault& fault) {
    console.err << "mien: " << fault.what() << '\n';
    return worker_disk_unavailable;
  } catch (const std::exception& error) {  // the folder cannot be written to
    console.err << "mien: " << failure_text(error) << '\n';
    return worker_transient;
  }
}

}  // namespace

Command farm_worker_command() {
  const auto arguments = std::make_shared<WorkerArguments>();
  return {
      .name = "worker",
      .summary =
          "Run tasks of a study in one of many cooperating processes; this is what farm jobs run",
      .options = all_of(
          manifest_options(arguments->production),
          option("--tasks", &arguments->tasks,
                 "Tasks listed by mien plan (film:walk-1), or chunks of a film's frames "
                 "(film:walk-1[3/12])"),
          option("--list", &arguments->list, "File with one line of tasks per job").needs("--line"),
          option("--line", &arguments->line, "Number of the line whose tasks to run, from 1")
              .between(1, 100000000)
              .needs("--list"),
          option("--expect", &arguments->expected,
                 "Key of the submitted study; a study with another key is refused")),
      .notes =
          "Any number of workers can work on a study at once, on machines that share its folder; "
          "each also makes missing inputs of its tasks.\n"
          "Exit codes: 0 done, 65 bad input, 70 failed, 74 disk full, read-only or unavailable, 75 "
          "interrupted or temporary failure, 78 wrong configuration.\n\n"
          "Examples:\n"
          "  mien farm worker my.yaml --tasks \"film:walk-1[1/2]\"\n"
          "  mien farm worker my.yaml --list films.tasks --line 3",
      .run = [arguments](const Console& console) { return worker(*arguments, console); }};
}

}  // namespace mien::pipeline
