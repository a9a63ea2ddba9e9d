#include "pipeline/commands/render_performances.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/fitting/recorded_points.h"
#include "motion/formats/motion_file.h"
#include "motion/lint/lint.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "motion/skeleton/simultaneous_frames.h"
#include "motion/skeleton/straighten.h"
#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

constexpr float superimposed_opacity = 0.75f;

/// `wanted`, or a variation of it that is not in `names` yet; adds it there.
std::string name_among(std::set<std::string>& names, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; !names.insert(name).second; ++number)
    name = fmt::format("{}-{}", wanted, number);
  return name;
}

/// A motion and the frame of its file that is its first: bodies are fitted to points only where
/// there are enough of them.
struct ReadMotion {
  motion::Recording recording;
  int first_frame = 0;
};

ReadMotion motion_in(const NamedRecording& named) {
  motion::FileContents contents = motion::read_file(named.file, named.how);
  if (auto* recording = std::get_if<motion::Recording>(&contents)) return {std::move(*recording)};
  motion::RecordedPoints points =
      motion::recorded_points(std::get<motion::PointRecording>(contents));
  return {std::move(points.recording), points.fit ? points.fit->first_frame : 0};
}

/// The recording's clip; prints warnings about its rig.
motion::Clip clip_in(const motion::Recording& recording, const std::string& file,
                     const Console& console) {
  for (const std::string& warning : motion::analyse_rig(recording).warnings)
    console.err << "warning: " << file << ": " << warning << '\n';
  motion::Clip clip = clip_of(recording);
  if (const std::optional<motion::Finding> pose = motion::calibration_pose(clip))
    console.err << "warning: " << file << ": " << pose->sentence << '\n';
  return clip;
}

motion::Clip as_filmed(const motion::Clip& clip, const Output& output) {
  motion::Clip at_rate = motion::resampled(clip, output.fps);
  return output.in_place ? motion::kept_in_place(at_rate) : at_rate;
}

/// The people of a file by name; a single empty name if it does not list any.
std::vector<std::string> people_in(const NamedRecording& named) {
  motion::FileContents contents = motion::read_file(named.file, named.how);
  std::vector<std::string> people =
      std::visit([](const auto& recording) { return recording.subjects; }, contents);
  if (people.size() < 2) return {""};
  if (std::ssize(people) <= most_people_shown) return people;
  throw Error(Place{named.file},
              fmt::format("holds {} people, but at most {} are shown together", people.size(),
                          most_people_shown),
              "choose one with --subject: " + motion::listed(people));
}

/// Everyone in a file, where they were recorded.
std::vector<scenes::Performance> people_of(NamedRecording named, const Output& output,
                                           const Console& console) {
  named.how.subject.reset();
  std::vector<scenes::Performance> performances;
  std::vector<motion::Clip> clips;
  std::vector<int> first_frames;
  std::set<std::string> names;
  for (const std::string& person : people_in(named)) {
    if (!person.empty()) named.how.subject = person;
    const ReadMotion motion = motion_in(named);
    const std::string file = person.empty() ? named.file : named.file + ", " + person;
    clips.push_back(clip_in(motion.recording, file, console));
    first_frames.push_back(motion.first_frame);
    performances.push_back({.name = name_among(names, person.empty() ? "figure" : person)});
  }
  if (!motion::cut_to_simultaneous_frames(clips, first_frames))
    throw Error(Place{named.file}, "there is no frame in which all people are known",
                "choose one with --subject");
  for (std::size_t i = 0; i < clips.size(); ++i) performances[i].clip = as_filmed(clips[i], output);
  return performances;
}

}  // namespace

RenderedMotions rendered_motions(const RenderOptions& options, const Output& output,
                                 const Console& console) {
  constexpr std::array roles = {scenes::Role::target, scenes::Role::created,
                                scenes::Role::reference};
  const std::vector<NamedRecording> files = named_recordings(options.files, options.recording);
  const bool is_alone = files.size() == 1;
  if (is_alone && files.front().how.subject == "all")
    return {people_of(files.front(), output, console), scenes::Layout::as_recorded};
  const bool is_clear = is_alone || options.layout != scenes::Layout::superimposed;
  std::set<std::string> names;
  RenderedMotions result{{}, options.layout};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& file = files[i].file;
    const motion::Recording recording = motion::read_motion(file, files[i].how);
    result.performances.push_back(
        {.name = name_among(names, std::filesystem::path(file).stem().string()),
         .clip = as_filmed(clip_in(recording, file, console), output),
         .role = is_alone ? scenes::Role::neutral : roles[i],
         .opacity = is_clear ? 1.0f : superimposed_opacity});
  }
  return result;
}

}  // namespace mien::pipeline
