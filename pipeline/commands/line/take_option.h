#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The option `--take`, which selects one motion of a file with several.
inline CommandOption take_option(std::string& take) {
  return option("--take", &take,
                "Motion to use from a file with several (listed by mien motion info)");
}

/// Which motion of the files of a command is used, and what the files do not state.
struct RecordingArguments {
  std::string take;
  std::string subject;
  double fps = 0.0;  ///< 0: as the file states it
  std::string body_model;
};

/// The options --take, --subject, --recorded-fps and --body-model.
inline std::vector<CommandOption> recording_options(RecordingArguments& arguments) {
  return {take_option(arguments.take),
          option("--subject", &arguments.subject,
                 "Name or number of the person to use from a file with several"),
          option("--recorded-fps", &arguments.fps,
                 "Frames per second of the recording, for files that do not state it (fps: in "
                 "manifests)")
              .positive(),
          option("--body-model", &arguments.body_model,
                 "Your SMPL, SMPL-H or SMPL-X model (.npz), whose proportions an SMPL motion "
                 "(.npz) gets")};
}

/// A motion file as named on the command line, and how it is read.
struct NamedRecording {
  std::string file;
  motion::ReadOptions how;
};

/// "walk.fbx#Run" is the take "Run" of walk.fbx, unless there is a file of that whole name.
inline NamedRecording named_recording(const std::string& name,
                                      const RecordingArguments& arguments) {
  NamedRecording named{name, {}};
  const std::size_t mark = name.rfind('#');
  std::error_code unknown;
  if (mark != std::string::npos && !std::filesystem::exists(name, unknown) &&
      std::filesystem::exists(name.substr(0, mark), unknown)) {
    named.file = name.substr(0, mark);
    named.how.take = name.substr(mark + 1);
  }
  if (!arguments.take.empty()) named.how.take = arguments.take;
  if (!arguments.subject.empty()) named.how.subject = arguments.subject;
  if (arguments.fps > 0.0) named.how.frames_per_second = arguments.fps;
  named.how.body_model = arguments.body_model;
  return named;
}

using motion::read_take;

/// Reads the motion of a file and prints the reader's notes as warnings, such as which figure was
/// chosen and, if no take is chosen, which take. Throws Error.
inline motion::Recording read_with_warnings(const std::string& file,
                                            const RecordingArguments& arguments,
                                            const Console& console) {
  const NamedRecording named = named_recording(file, arguments);
  motion::Recording recording = motion::read_motion(named.file, named.how);
  for (const std::string& note : recording.notes)
    console.err << "warning: " << file << ": " << note << '\n';
  return recording;
}

/// The name of the recording's take if its file has several; otherwise empty.
inline std::string chosen_take(const motion::Recording& recording) {
  return recording.takes.size() > 1 ? recording.take : "";
}

/// Throws Error if the output file is the input file.
inline void refuse_own_input(const std::string& input, const std::string& written) {
  std::error_code unknown;
  if (std::filesystem::equivalent(input, written, unknown))
    throw Error(Place{written}, "is the input file", "name another file to write");
}

/// The option `--take` of a command that compares two files: given once for both, or once for each.
inline CommandOption takes_option(std::vector<std::string>& takes) {
  return option("--take", &takes,
                "Motion to use from files with several (listed by mien motion info); give "
                "twice for the first and the second file")
      .values(1, 1);
}

/// The takes of two files that are compared. A single name applies to each file whose format may
/// contain several. Throws mien::Error for more than two names. A name that does not apply to
/// either file is refused when the first file is read.
inline std::array<std::string, 2> takes_of(const std::vector<std::string>& takes,
                                           const std::array<std::string, 2>& files) {
  if (takes.size() > 2)
    throw Error(fmt::format("--take was given {} times for two files", takes.size()),
                "give it once for both, or once for each in their order");
  if (takes.size() == 2) return {takes[0], takes[1]};
  if (takes.empty()) return {};
  std::array<std::string, 2> result;
  bool is_of_any = false;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!motion::may_hold_takes(files[i])) continue;
    result[i] = takes[0];
    is_of_any = true;
  }
  // The reader of the first file reports the error.
  if (!is_of_any) result[0] = takes[0];
  return result;
}

}  // namespace mien::pipeline
