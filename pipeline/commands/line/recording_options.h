#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/formats/fitted_file.h"
#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/recording.h"
#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/recording_choice.h"

namespace mien::pipeline {

/// How the motion files of a command are read: values of --take, --subject, --recorded-fps,
/// --joints and --body-model. Each option is given once for all files, or once for each file in
/// their order.
struct RecordingArguments {
  std::vector<std::string> takes;
  std::vector<std::string> subjects;
  std::vector<double> rates;        ///< frames per second
  std::vector<std::string> joints;  ///< each the name of a known order, or names with commas
  std::vector<std::string> body_models;

  bool are_given() const {
    return !takes.empty() || !subjects.empty() || !rates.empty() || !joints.empty() ||
           !body_models.empty();
  }
};

/// The options of a command that reads one motion file.
std::vector<CommandOption> recording_options(RecordingArguments& arguments);

/// The options of a command that reads several motion files.
std::vector<CommandOption> options_of_recordings(RecordingArguments& arguments);

/// A motion file as named on the command line, and how it is read.
struct NamedRecording {
  std::string file;
  motion::ReadOptions how;
};

/// The files and how each is read. "walk.fbx#Run" is the take "Run" of walk.fbx, unless there is a
/// file of that whole name. What is given once applies to all files whose format may hold several
/// takes or people, points without names, or SMPL motions; a take after # goes before it. If it
/// applies to none, it is left to the first file, whose reader refuses it. Throws Error if an
/// option is given otherwise than once or once for each file, or if a file has two different takes.
std::vector<NamedRecording> named_recordings(const std::vector<std::string>& names,
                                             const RecordingArguments& arguments);

/// As above, for one file.
NamedRecording named_recording(const std::string& name, const RecordingArguments& arguments = {});

/// The choice for a folder of files. Throws Error if an option is given more than once.
RecordingChoice recording_choice(const RecordingArguments& arguments);

/// Read a motion and print the reader's notes as warnings, such as which take or person is used if
/// none was chosen. Throw Error.
motion::FittedFile read_fitted_with_warnings(const NamedRecording& named, const Console& console);
motion::Recording read_with_warnings(const NamedRecording& named, const Console& console);

/// The name of the recording's take if its file has several; otherwise empty.
std::string chosen_take(const motion::Recording& recording);

/// The name of the recording's person if its file has several; otherwise empty.
std::string chosen_person(const motion::Recording& recording);

/// Throws Error if the output file is the input file.
void refuse_own_input(const std::string& input, const std::string& written);

/// Throws Error if the motion file to be written, or a file beside it (written_files), is one of
/// the input files or belongs beside one of them. Empty paths are ignored.
void refuse_own_inputs(const std::vector<std::filesystem::path>& inputs,
                       const std::filesystem::path& out);

}  // namespace mien::pipeline
