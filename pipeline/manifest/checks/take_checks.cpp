#include "pipeline/manifest/checks/take_checks.h"

#include <deque>
#include <utility>

#include <fmt/format.h>

#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/motion_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/named_motions.h"

namespace mien::pipeline {

namespace {

/// Motion files that are read once each.
class ReadTakes {
 public:
  struct Take {
    motion::Recording recording;  ///< without poses when there is none
    std::string wrong;
  };

  const Take& of(const std::filesystem::path& file, const motion::ReadOptions& how) {
    for (const auto& [key, take] : takes_)
      if (key.first == file && key.second == how) return take;
    Take& take = takes_.emplace_back(std::pair(file, how), Take()).second;
    try {
      take.recording = motion::read_motion(file, how);
    } catch (const Error& error) {
      take.wrong = error.what();
    }
    return take;
  }

 private:
  std::deque<std::pair<std::pair<std::filesystem::path, motion::ReadOptions>, Take>> takes_;
};

/// Whether the file can be read and may contain the take.
bool is_readable(const NamedMotion& motion) {
  return motion::is_motion_file(motion.file) &&
         (!motion.how.take || motion::may_hold_takes(motion.file)) &&
         motion::read_error(motion.file, motion::max_recording_bytes).empty();
}

void check_recording(const NamedMotion& motion, ReadTakes& takes, FaultList& list) {
  if ((motion.how == motion::ReadOptions() && motion.last_frame == 0) || !is_readable(motion))
    return;
  const auto& [recording, wrong] = takes.of(motion.file, motion.how);
  if (!wrong.empty())
    return list.add(motion.how.take ? member_path(motion.path, "take") : motion.path, wrong, "");
  if (const std::string fault = frame_fault(recording, motion.last_frame); !fault.empty()) {
    list.add(motion.frame_at, motion.file.string() + ": " + fault,
             fmt::format("name a frame from 0 to {}", recording.frame_count() - 1));
  }
}

/// Notes the take that is used by default; skips files that cannot be read.
void add_default_take(const NamedMotion& motion, FaultList& list) {
  try {
    const std::string note = is_readable(motion) ? default_take_note(motion) : "";
    if (note.empty()) return;
    const std::string own = member_path(motion.path, motion.key);
    list.add(list.was_given(own) ? own : motion.path, motion.file.string() + ": " + note,
             "add take:");
  } catch (const Error&) {
    // Reported when the motion is made.
  }
}

/// Adds the fault of a folder of OpenPose's frames that is not one recording's; false for others.
bool add_frame_folder(const std::string& at, const std::filesystem::path& file, FaultList& list) {
  if (motion::keypoint_recordings(file).empty()) return false;
  try {
    motion::only_keypoint_recording(file);
    return false;
  } catch (const Error& error) {
    list.add(at, error.what(), "");
    return true;
  }
}

}  // namespace

void check_motion_file(const std::string& path, const std::filesystem::path& file,
                       const motion::ReadOptions& how, FaultList& list) {
  if (file.empty()) return;
  const std::string own = member_path(path, "file");
  const std::string at = list.was_given(own) ? own : path;
  if (add_frame_folder(at, file, list)) return;
  list.check_file(at, file, "a motion file: " + motion::formats_read(),
                  motion::max_recording_bytes);
  check_take(member_path(path, "take"), file, how, list);
  check_body_model(member_path(path, "body_model"), file, how, list);
  if (motion::is_motion_file(file)) return;
  list.add(at, motion::in_quotes(file.extension().string()) + " is not a motion file format",
           "use " + motion::formats_read());
}

void check_body_model(const std::string& path, const std::filesystem::path& file,
                      const motion::ReadOptions& how, FaultList& list) {
  if (how.body_model.empty()) return;
  if (motion::is_motion_file(file) && motion::lower_case_ending(file) != ".npz") {
    list.add(path, "a file of " + file.extension().string() + " holds no SMPL motion",
             "omit body_model; only SMPL motions (.npz) take one");
  }
  list.check_file(path, how.body_model, "an SMPL, SMPL-H or SMPL-X model (.npz)",
                  motion::max_recording_bytes);
}

void check_take(const std::string& path, const std::filesystem::path& file,
                const motion::ReadOptions& how, FaultList& list) {
  if (!how.take || !motion::is_motion_file(file) || motion::may_hold_takes(file)) return;
  list.add(path, "a file of " + file.extension().string() + " holds one motion",
           "omit take; only " + motion::formats_with_takes() + " can hold several");
}

std::vector<Fault> check_recordings(const Manifest& manifest) {
  FaultList list(manifest.places);
  ReadTakes takes;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.foil) continue;
    for (const NamedMotion& motion : named_motions(stimulus)) check_recording(motion, takes, list);
  }
  return list.take();
}

std::vector<Fault> default_take_warnings(const Manifest& manifest) {
  FaultList list(manifest.places);
  const Examples& examples = manifest.examples;
  if (examples.builtin.empty() && !examples.folder.empty() && examples.how.take.empty()) {
    for (const auto& file : motion::example_files(example_folder(examples)))
      add_default_take({"examples.set", "folder", file, read_options(examples.how), 0, ""}, list);
  }
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.foil) continue;
    for (const NamedMotion& motion : named_motions(stimulus)) add_default_take(motion, list);
  }
  return list.take();
}

}  // namespace mien::pipeline
