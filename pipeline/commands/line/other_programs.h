#pragma once

#include <string>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// A command of mien that another program has, which lies beside it: `mien study` becomes
/// mien-study, as git does it, so that who only renders builds and loads nothing of a server.
struct OtherProgram {
  const char* command;
  const char* summary;
  const char* program;
};
inline constexpr OtherProgram regress_program{
    "regress", "Compare a study or a motion with an approved state, and report changes",
    "mien-regress"};
inline constexpr OtherProgram studio_program{
    "studio", "Edit a manifest's motions with sliders in the browser", "mien-study"};
inline constexpr OtherProgram study_program{
    "study", "Design, run and analyse rating studies and matching experiments", "mien-study"};
inline constexpr OtherProgram other_programs[] = {regress_program, studio_program, study_program};

/// As `mien --help` lists it; what is below it, its program tells.
Command command_elsewhere(const OtherProgram& other);

/// Becomes the program that has the command that was typed, with all words as they are; returns
/// where it is one of this program. Throws std::runtime_error when the other one is not there.
void become_other_program(int argc, char** argv);

/// Ends with an error where mien of another version started this program. Throws
/// std::runtime_error.
void refuse_other_version();

/// The commands of a program as JSON, from which another program makes its help and manual.
std::string program_as_json(const Command& program);

/// The program with all that the others beside it tell of their commands. Throws
/// std::runtime_error when one of them is not there or does not answer.
Command with_other_programs(Command program);

}  // namespace mien::pipeline
