#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/printable_stream.h"
#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/farm_status.h"
#include "pipeline/farm/slurm/slurm.h"

namespace mien::pipeline {

namespace {

struct StatusCommand {
  FarmArguments study;
  std::optional<double> watch;  ///< seconds between looks
  bool json = false;
};

FarmStatus status_of(const FarmStudy& study, const FarmArguments& arguments) {
  std::string fault;
  const Slurm slurm;
  const auto queue = slurm.queue_if_any(fault);
  return farm_status(study.production, study.folder, queue, fault, study_arguments(arguments),
                     queue ? slurm.node_states() : NodeStates());
}

void show(const FarmStatus& status, const StatusCommand& command, const Console& console) {
  if (command.json) {
    console.out << status_json(status).dump(command.watch ? -1 : 2, ' ', false,
                                            nlohmann::ordered_json::error_handler_t::replace)
                << '\n';
  } else {
    console.out << status_text(status);
  }
  console.out.flush();
}

/// Waits; returns false if the user requests a stop.
bool wait_for(double seconds, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
  return !stop.stop_requested();
}

int watch_study(const FarmStudy& study, const StatusCommand& command, const Console& console) {
  constexpr const char* clear_screen = "\x1b[H\x1b[J";
  const bool redraws = console.err_is_terminal && !command.json;
  int frames = 0;
  while (true) {
    FarmStatus status = status_of(study, command.study);
    // A film's frames are removed a moment before its video is published.
    status.frames.done = frames = std::max(frames, status.frames.done);
    if (redraws) put_control(console.out, clear_screen);
    show(status, command, console);
    if (status.is_complete) return exit_done;
    if (!status.is_active() && status.without_slurm.empty()) {
      console.err << "no worker is active; mien farm resume " << study_arguments(command.study)
                  << " submits what is missing\n";
      return exit_failed;
    }
    if (!wait_for(*command.watch, console.stop)) return exit_interrupted;
  }
}

int show_status(const StatusCommand& command, const Console& console) {
  const FarmStudy study(command.study, console);
  if (command.watch) return watch_study(study, command, console);
  show(status_of(study, command.study), command, console);
  return exit_done;
}

}  // namespace

Command farm_status_command() {
  const auto options = std::make_shared<StatusCommand>();
  return {
      .name = "status",
      .summary = "Show what is done, what is running where, and what failed and why",
      .options = all_of(
          farm_options(options->study),
          option(
              "--watch", &options->watch,
              "Repeat until everything is done, at this interval in seconds (without a value: 5)")
              .values(0, 1)
              .with_default("5")
              .between(0.5, 86400.0),
          flag("--json", &options->json,
               "As JSON on standard output; with --watch one line per update")),
      .notes =
          "The status is read from the study's folder, from the reports of workers and, with "
          "Slurm, from squeue.\n\nExample:\n  mien farm status my.yaml --watch",
      .run = [options](const Console& console) { return show_status(*options, console); }};
}

}  // namespace mien::pipeline
