#include "pipeline/commands/line/external_programs.h"

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

std::runtime_error missing_program(const std::string& program, const std::string& command) {
  return std::runtime_error(
      fmt::format("{}: the program for mien {} was not found; it is part of the mien package, and "
                  "./mien {} builds it in the source tree",
                  program, command, command));
}

std::filesystem::path program_path() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}

std::string path_of(const ExternalProgram& other) {
  return program_path().replace_filename(other.program);
}

Command commands_of(const std::string& program, const std::string& command) {
  const CommandResult end = run_command({program, "--commands"}, std::chrono::seconds(30));
  if (end.is_missing) throw missing_program(program, command);
  if (!end.succeeded())
    throw std::runtime_error(program + " does not list its commands: " + end.errors);
  const nlohmann::json reply = nlohmann::json::parse(end.output);
  if (reply.at("version") != program_version())
    throw std::runtime_error(
        fmt::format("{} has version {}, but mien has {}; install or build both", program,
                    reply.at("version").get<std::string>(), program_version()));
  return reply.at("program").get<Command>();
}

}  // namespace

Command external_command(const ExternalProgram& other) {
  return {.name = other.command, .summary = other.summary};
}

void exec_external_program(int argc, char** argv) {
  const int at = argc > 1 && std::string_view(argv[1]) == "help" ? 2 : 1;
  if (argc <= at) return;
  const auto* const other =
      std::ranges::find(external_programs, std::string_view(argv[at]), &ExternalProgram::command);
  if (other == std::end(external_programs) || program_path().filename() == other->program) return;
  const std::string program = path_of(*other);
  ::setenv(started_by, std::string(program_version()).c_str(), 1);
  ::execv(program.c_str(), argv);
  throw missing_program(program, other->command);
}

void refuse_version_mismatch() {
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

Command with_external_programs(Command program) {
  for (const ExternalProgram& other : external_programs) {
    const Command reply = commands_of(path_of(other), other.command);
    const Command* const command = subcommand_named(reply, other.command);
    if (command != nullptr)
      *std::ranges::find(program.commands, other.command, &Command::name) = *command;
  }
  return program;
}

Command with_other_programs(const Command& program) {
  const std::string main_program = program_path().replace_filename("mien");
  try {
    return with_external_programs(commands_of(main_program, ""));
  } catch (const std::runtime_error&) {
    return program;
  }
}

}  // namespace mien::pipeline
