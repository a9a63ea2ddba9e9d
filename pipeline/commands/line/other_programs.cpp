#include "pipeline/commands/line/other_programs.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/command_run.h"

namespace mien::pipeline {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CommandOption, names, argument, value, choices, limits, usual,
                                   help, is_required, repeats)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Command, name, summary, options, commands, notes)

namespace {

/// Environment variable with the version of mien that started a program.
constexpr char started_by[] = "MIEN_STARTED_BY";

std::runtime_error not_there(const std::string& program, const std::string& command) {
  return std::runtime_error(
      fmt::format("{}: the program for mien {} was not found; it is part of the mien package, and "
                  "./mien {} builds it in the source tree",
                  program, command, command));
}

std::filesystem::path own_path() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}

std::string path_of(const OtherProgram& other) {
  return own_path().replace_filename(other.program);
}

Command told_by(const OtherProgram& other) {
  const std::string program = path_of(other);
  const CommandEnd end = run_command({program, "--commands"}, std::chrono::seconds(30));
  if (end.is_missing) throw not_there(program, other.command);
  if (!end.is_done())
    throw std::runtime_error(program + " does not list its commands: " + end.errors);
  const nlohmann::json told = nlohmann::json::parse(end.output);
  if (told.at("version") != program_version())
    throw std::runtime_error(
        fmt::format("{} has version {}, but mien has {}; install or build both", program,
                    told.at("version").get<std::string>(), program_version()));
  return told.at("program").get<Command>();
}

}  // namespace

Command command_elsewhere(const OtherProgram& other) {
  return {.name = other.command, .summary = other.summary};
}

void become_other_program(int argc, char** argv) {
  const int at = argc > 1 && std::string_view(argv[1]) == "help" ? 2 : 1;
  if (argc <= at) return;
  const auto* const other =
      std::ranges::find(other_programs, std::string_view(argv[at]), &OtherProgram::command);
  if (other == std::end(other_programs) || own_path().filename() == other->program) return;
  const std::string program = path_of(*other);
  ::setenv(started_by, std::string(program_version()).c_str(), 1);
  ::execv(program.c_str(), argv);
  throw not_there(program, other->command);
}

void refuse_other_version() {
  const char* const version = std::getenv(started_by);
  if (version == nullptr) return;
  const std::string starter = version;
  ::unsetenv(started_by);
  if (starter == program_version()) return;
  throw std::runtime_error(fmt::format(
      "this program has version {}, but mien, which started it, has {}; install or build both",
      program_version(), starter));
}

std::string program_as_json(const Command& program) {
  return nlohmann::json{{"version", program_version()}, {"program", program}}.dump();
}

Command with_other_programs(Command program) {
  for (const OtherProgram& other : other_programs) {
    const Command told = told_by(other);
    const Command* const command = command_below(told, other.command);
    if (command != nullptr)
      *std::ranges::find(program.commands, other.command, &Command::name) = *command;
  }
  return program;
}

}  // namespace mien::pipeline
