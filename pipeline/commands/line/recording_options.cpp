#include "pipeline/commands/line/recording_options.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/motion_file.h"
#include "motion/formats/motion_format.h"
#include "motion/formats/written_motion.h"
#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

constexpr char once_for_each[] = "; once for all files, or once for each in their order";

/// "walk.fbx#Run" as walk.fbx and its take.
NamedRecording split_name(const std::string& name) {
  NamedRecording named{name, {}};
  const std::size_t mark = name.rfind('#');
  std::error_code unknown;
  if (mark != std::string::npos && !std::filesystem::exists(name, unknown) &&
      std::filesystem::exists(name.substr(0, mark), unknown)) {
    named.file = name.substr(0, mark);
    named.how.take = name.substr(mark + 1);
  }
  return named;
}

void check_count(const char* option, std::size_t given, std::size_t files) {
  if (given <= 1 || given == files) return;
  if (files == 1)
    throw Error(fmt::format("{} was given {} times for one file", option, given), "give it once");
  throw Error(fmt::format("{} was given {} times for {} files", option, given, files),
              "give it once for all files, or once for each in their order");
}

/// Of a folder of frames, that of the frames.
const motion::MotionFormat* format_of(const std::string& file) {
  const std::vector<std::filesystem::path> frames = motion::keypoint_recordings(file);
  return motion::motion_format(frames.empty() ? std::filesystem::path(file) : frames.front());
}

/// Applies the values of an option to the files: one to each, or a single one to all those to which
/// it may apply, and to the first if there are none.
template <class Value>
void give(const char* option, const std::vector<Value>& given, std::vector<NamedRecording>& files,
          bool (*may_apply)(const motion::MotionFormat&),
          void (*set)(NamedRecording& named, const Value& value)) {
  check_count(option, given.size(), files.size());
  if (given.empty() || files.empty()) return;
  if (given.size() == files.size()) {
    for (std::size_t i = 0; i < files.size(); ++i) set(files[i], given[i]);
    return;
  }
  bool is_of_any = false;
  for (NamedRecording& named : files) {
    const motion::MotionFormat* const format = format_of(named.file);
    if (format == nullptr || !may_apply(*format)) continue;
    if (option == std::string_view("--take") && named.how.take) continue;
    set(named, given.front());
    is_of_any = true;
  }
  if (!is_of_any) set(files.front(), given.front());
}

void set_take(NamedRecording& named, const std::string& take) {
  if (take.empty()) return;
  if (named.how.take && *named.how.take != take)
    throw Error(fmt::format("--take: {} names the take {} of this file, not {}",
                            motion::in_quotes(named.file + "#" + *named.how.take),
                            motion::in_quotes(*named.how.take), motion::in_quotes(take)),
                "omit one of them");
  named.how.take = take;
}

void set_subject(NamedRecording& named, const std::string& subject) {
  if (!subject.empty()) named.how.subject = subject;
}

void set_rate(NamedRecording& named, const double& rate) { named.how.frames_per_second = rate; }

std::vector<std::string> parts_of_list(std::string_view list) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    parts.emplace_back(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return parts;
}

void set_joints(NamedRecording& named, const std::string& joints) {
  named.how.joints = parts_of_list(joints);
}

void set_body_model(NamedRecording& named, const std::string& model) {
  named.how.body_model = model;
}

std::vector<CommandOption> options_for(RecordingArguments& arguments,
                                       const std::string& how_often) {
  return {
      option("--take", &arguments.takes,
             "Motion to use from a file with several (listed by mien motion info); also as "
             "FILE#TAKE" +
                 how_often)
          .values(1, 1),
      option("--subject", &arguments.subjects,
             "Name or number of the person to use from a file with several (listed by mien "
             "motion info)" +
                 how_often)
          .values(1, 1),
      option("--recorded-fps", &arguments.rates,
             "Frames per second of the recording, for files that do not state it; a rate that the "
             "file states is used instead (fps: in manifests)" +
                 how_often)
          .values(1, 1)
          .positive(),
      option("--joints", &arguments.joints,
             "Points of a file without names: their names, separated by commas, or humanml3d, "
             "smpl, h36m, kinect, body_25 or mediapipe for a known order" +
                 how_often)
          .values(1, 1),
      option("--body-model", &arguments.body_models,
             "Your SMPL, SMPL-H or SMPL-X model (.npz), whose proportions an SMPL motion "
             "(.npz) gets" +
                 how_often)
          .values(1, 1)};
}

}  // namespace

std::vector<CommandOption> recording_options(RecordingArguments& arguments) {
  return options_for(arguments, "");
}

std::vector<CommandOption> options_of_recordings(RecordingArguments& arguments) {
  return options_for(arguments, once_for_each);
}

std::vector<NamedRecording> named_recordings(const std::vector<std::string>& names,
                                             const RecordingArguments& arguments) {
  using motion::MotionFormat;
  std::vector<NamedRecording> files;
  for (const std::string& name : names) files.push_back(split_name(name));
  give<std::string>(
      "--take", arguments.takes, files, [](const MotionFormat& f) { return f.has_takes; },
      set_take);
  give<std::string>(
      "--subject", arguments.subjects, files, [](const MotionFormat& f) { return f.has_subjects; },
      set_subject);
  give<double>(
      "--recorded-fps", arguments.rates, files, [](const MotionFormat&) { return true; }, set_rate);
  give<std::string>(
      "--joints", arguments.joints, files,
      [](const MotionFormat& f) { return f.has_nameless_points; }, set_joints);
  give<std::string>(
      "--body-model", arguments.body_models, files,
      [](const MotionFormat& f) { return f.ending == ".npz"; }, set_body_model);
  return files;
}

NamedRecording named_recording(const std::string& name, const RecordingArguments& arguments) {
  return named_recordings({name}, arguments).front();
}

RecordingChoice recording_choice(const RecordingArguments& arguments) {
  check_count("--take", arguments.takes.size(), 1);
  check_count("--subject", arguments.subjects.size(), 1);
  check_count("--recorded-fps", arguments.rates.size(), 1);
  check_count("--joints", arguments.joints.size(), 1);
  check_count("--body-model", arguments.body_models.size(), 1);
  RecordingChoice choice;
  if (!arguments.takes.empty()) choice.take = arguments.takes.front();
  if (!arguments.subjects.empty()) choice.subject = arguments.subjects.front();
  if (!arguments.rates.empty()) choice.fps = arguments.rates.front();
  if (!arguments.joints.empty()) choice.joints = parts_of_list(arguments.joints.front());
  if (!arguments.body_models.empty()) choice.body_model = arguments.body_models.front();
  return choice;
}

motion::FittedFile read_fitted_with_warnings(const NamedRecording& named, const Console& console) {
  motion::FittedFile read = motion::read_fitted(named.file, named.how);
  for (const std::string& note : read.recording.notes)
    console.err << "warning: " << named.file << ": " << note << '\n';
  return read;
}

motion::Recording read_with_warnings(const NamedRecording& named, const Console& console) {
  return read_fitted_with_warnings(named, console).recording;
}

std::string chosen_take(const motion::Recording& recording) {
  return recording.takes.size() > 1 ? recording.take : "";
}

std::string chosen_person(const motion::Recording& recording) {
  return recording.subjects.size() > 1 ? recording.subject : "";
}

void refuse_own_input(const std::string& input, const std::string& written) {
  std::error_code unknown;
  if (std::filesystem::equivalent(input, written, unknown))
    throw Error(Place{written}, "is the input file", "name another file to write");
}

void refuse_own_inputs(const std::vector<std::filesystem::path>& inputs,
                       const std::filesystem::path& out) {
  for (const std::filesystem::path& written : motion::written_files(out)) {
    for (const std::filesystem::path& input : inputs) {
      refuse_own_input(input.string(), written.string());
      for (const std::filesystem::path& companion : motion::companion_files(input))
        refuse_own_input(companion.string(), written.string());
    }
  }
}

}  // namespace mien::pipeline
