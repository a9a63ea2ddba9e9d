// Recordings of one file per frame, as OpenPose writes them.

#include <utility>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/keypoints/keypoint_take.h"
#include "motion/formats/keypoints/keypoints.h"
#include "motion/formats/reading/json_text.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "motion/text/frame_file_name.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json frame_in(const std::string& text, const std::string& file) {
  if (text.find_first_of('{') == std::string::npos) require_kind(text, file, "json");
  Json frame = parse_json_text(text, file, "keypoints");
  const auto people = frame.is_object() ? frame.find("people") : frame.end();
  if (!frame.is_object() || people == frame.end() || !people->is_array())
    throw Error({file}, "has no list of people", "give frames as OpenPose writes them");
  return frame;
}

std::string note_on_frames(const fs::path& frame, std::size_t count) {
  const fs::path folder = frame.parent_path().filename();
  const std::string of = in_quotes(frame_file_name(frame)->recording);
  const std::string where =
      folder.empty() ? "its folder" : "the folder " + in_quotes(folder.string());
  if (count == 1) return "The file is the only frame of " + of + " in " + where + ".";
  return "The file is one of the " + std::to_string(count) + " frames of " + of +
         "; all those in " + where + " are read.";
}

}  // namespace

PointRecording read_keypoint_files(const fs::path& path, const ReadOptions& options) {
  std::error_code unknown;
  const bool is_folder = fs::is_directory(path, unknown);
  const fs::path first = is_folder ? only_keypoint_recording(path) : path;
  const std::vector<fs::path> files = keypoint_frames(first);
  // A file that is not there: reading it says so.
  if (files.empty()) read_contents(path);
  require_readable_frames(files);
  Json frames = Json::array();
  std::vector<std::int64_t> numbers;
  std::size_t bytes = 0;
  for (const fs::path& file : files) {
    const std::string text = read_contents(file);
    bytes += text.size();
    require_keypoint_bytes(bytes, path.string());
    frames.push_back(frame_in(text, file.string()));
    numbers.push_back(frame_file_name(file)->number);
  }
  PointRecording recording =
      recording_of_frames({frames, path.string(), options}, std::move(numbers), bytes);
  recording.name = frame_file_name(first)->recording;
  // The first of several frames stands for all of them, as their folder does.
  if (!is_folder && (files.size() == 1 || path != files.front()))
    recording.notes.push_back(note_on_frames(path, files.size()));
  return recording;
}

}  // namespace mien::motion
