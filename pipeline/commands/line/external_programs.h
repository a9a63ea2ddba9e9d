#pragma once

#include <string>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// A command of mien that is implemented by another program in the same folder, as in git:
/// `mien study` executes mien-study. Rendering alone thus does not require building or loading a
/// server.
struct ExternalProgram {
  const char* command;
  const char* summary;
  const char* program;
};
inline constexpr ExternalProgram regress_program{
    "regress", "Compare a study or a motion with an approved state, and report changes",
    "mien-regress"};
inline constexpr ExternalProgram studio_program{
    "studio", "Edit a manifest's motions with sliders in the browser", "mien-study"};
inline constexpr ExternalProgram study_program{
    "study", "Design, run and analyse rating studies and matching experiments", "mien-study"};
inline constexpr ExternalProgram external_programs[] = {regress_program, studio_program,
                                                        study_program};

/// The command as listed by `mien --help`, without its subcommands.
Command external_command(const ExternalProgram& other);

/// Replaces the process (exec) with the program that implements the given command, with the same
/// arguments. Returns if no other program implements it. Throws std::runtime_error if the other
/// program is missing.
void exec_external_program(int argc, char** argv);

/// Throws std::runtime_error if this program was started by another version of mien.
void refuse_version_mismatch();

/// The commands of a program as JSON, from which `mien` generates its manual page and completions.
std::string program_as_json(const Command& program);

/// Replaces the commands of `program` that other programs implement by their full descriptions.
/// Throws std::runtime_error if one of these programs is missing, has another version or fails to
/// describe its commands.
Command with_external_programs(Command program);

/// All commands of mien, from whichever of its programs this is, to suggest one to somebody who
/// typed another; only those of `program` if another program is missing or cannot list its own.
Command with_other_programs(const Command& program);

}  // namespace mien::pipeline
