#include "motion/formats/keypoints/keypoint_frames.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "motion/error.h"
#include "motion/formats/keypoints/keypoints.h"
#include "motion/text/excerpt.h"
#include "motion/text/frame_file_name.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;

/// The frames in a folder with their numbers, by the recordings' names.
using FramesByName = std::map<std::string, std::vector<std::pair<std::int64_t, fs::path>>>;

FramesByName frames_in(const fs::path& folder) {
  FramesByName frames;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    if (entry->path().filename().string().starts_with('.')) continue;
    const std::optional<FrameFileName> name = frame_file_name(entry->path());
    std::error_code unknown;
    if (name && entry->is_regular_file(unknown))
      frames[name->recording].emplace_back(name->number, entry->path());
  }
  for (auto& [name, files] : frames) std::ranges::sort(files);
  return frames;
}

}  // namespace

std::vector<fs::path> keypoint_frames(const fs::path& frame) {
  const std::optional<FrameFileName> name = frame_file_name(frame);
  const fs::path folder = frame.has_parent_path() ? frame.parent_path() : ".";
  std::vector<fs::path> files;
  if (!name) return files;
  const FramesByName frames = frames_in(folder);
  const auto found = frames.find(name->recording);
  if (found == frames.end()) return files;
  for (const auto& [number, file] : found->second)
    files.push_back(frame.has_parent_path() ? file : file.filename());
  return files;
}

std::vector<fs::path> keypoint_recordings(const fs::path& folder) {
  std::vector<fs::path> first;
  for (const auto& [name, files] : frames_in(folder)) first.push_back(files.front().second);
  return first;
}

fs::path only_keypoint_recording(const fs::path& folder) {
  const std::vector<fs::path> recordings = keypoint_recordings(folder);
  if (recordings.size() == 1) return recordings.front();
  if (recordings.empty())
    throw Error({folder.string()}, "is a folder",
                "name a motion file in it, or a folder of OpenPose's frames "
                "(NAME_000000000000_keypoints.json)");
  std::vector<std::string> names;
  for (const fs::path& frame : recordings) names.push_back(frame_file_name(frame)->recording);
  throw Error(
      {folder.string()},
      "holds the frames of " + std::to_string(names.size()) + " recordings: " + listed(names),
      "name a frame of one of them, such as " + recordings.front().string() +
          ": all its frames are read");
}

void require_readable_frames(const std::vector<fs::path>& frames) {
  const auto refuse = [&](const std::string& wrong) {
    throw Error({frames.front().parent_path().string()}, wrong,
                "cut the recording into shorter ones, each in a separate folder");
  };
  if (frames.size() > max_keypoint_frames)
    refuse("holds " + std::to_string(frames.size()) + " frames, more than the " +
           std::to_string(max_keypoint_frames) + " that can be read");
  std::uintmax_t bytes = 0;
  for (const fs::path& frame : frames) {
    std::error_code unknown;
    const std::uintmax_t size = fs::file_size(frame, unknown);
    if (!unknown) bytes += size;
    if (bytes > max_keypoint_bytes)
      refuse("holds frames of more than the " + std::to_string(max_keypoint_bytes >> 20) +
             " MiB that can be read");
  }
}

}  // namespace mien::motion
