#include "motion/formats/keypoints/keypoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "motion/formats/keypoints/keypoint_take.h"
#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/json_text.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/table/column_name.h"
#include "motion/points/joint_orders.h"
#include "motion/points/point_names.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "motion/text/frame_file_name.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;

constexpr char known_layouts[] = "keypoints of OpenPose, MediaPipe or FreeMoCap are read";

/// The list of frames, or the whole file as the only one.
std::vector<const Json*> frames_of(const Json& json) {
  const Json* list = &json;
  if (json.is_object()) {
    const auto frames = json.find("frames");
    if (frames == json.end() || !frames->is_array()) return {&json};
    list = &*frames;
  } else if (!json.empty() && json[0].is_object() && json[0].contains("x")) {
    return {&json};
  }
  std::vector<const Json*> frames;
  for (const Json& frame : *list) frames.push_back(&frame);
  return frames;
}

std::optional<double> stated_rate(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  for (const char* const key : {"fps", "frame_rate", "frameRate", "frames_per_second"}) {
    const auto found = json.find(key);
    if (found != json.end() && found->is_number()) return found->get<double>();
  }
  return std::nullopt;
}

/// Frame numbers and times that all frames state.
void read_times(const std::vector<const Json*>& frames, MomentTimes& times) {
  for (const Json* const frame : frames) {
    if (!frame->is_object()) return;
    std::optional<double> number;
    std::optional<double> time;
    for (auto field = frame->begin(); field != frame->end(); ++field) {
      if (!field->is_number()) continue;
      const NamedColumn named = named_column(field.key());
      const double value = field->get<double>();
      if (named.use == ColumnUse::frame && value == std::floor(value) && std::abs(value) < 1e12)
        number = value;
      if (named.use != ColumnUse::time || time) continue;
      time = value;
      times.seconds_per_unit = named.seconds_per_unit;
      times.has_unit = named.has_unit;
      note_last_digit(times, field->dump());
    }
    if (number) times.numbers.push_back(static_cast<std::int64_t>(*number));
    if (time) times.times.push_back(*time);
  }
  if (times.numbers.size() < frames.size()) times.numbers.clear();
  if (times.times.size() < frames.size()) times.times.clear();
}

KeypointTake take_of(const KeypointFile& file) {
  const Json& json = file.json;
  if (!json.is_structured()) throw Error({file.name}, "holds no keypoints", known_layouts);
  if (json.is_object() && json.contains("data_by_frame")) return freemocap_take(file);
  const std::vector<const Json*> frames = frames_of(json);
  if (frames.empty())
    throw Error({file.name}, "there are no frames", "give a recording of at least one frame");
  const auto has = [&](const char* key) {
    return frames[0]->is_object() && frames[0]->contains(key);
  };
  if (has("keypoints") && !has("keypoints3D") && !has("keypoints_3d"))
    refuse_flat(file, "keypoints of COCO or AlphaPose");
  KeypointTake take = has("people") ? openpose_take(frames, file) : mediapipe_take(frames, file);
  read_times(frames, take.times);
  return take;
}

/// `moment` is what messages call the source of a frame.
PointRecording recording_of(KeypointTake take, const KeypointFile& file, std::size_t bytes,
                            const char* moment) {
  take.times.count = take.moments.size();
  take.times.stated_rate = stated_rate(file.json);
  take.times.rate_source = "The file";
  take.times.moment = moment;
  take.times.place = [&](std::size_t) { return Place{file.name}; };
  const FrameTiming timing = timing_of(take.times, file.name, file.options);
  const std::size_t points = take.points.size();
  require_present_size({file.name}, points, timing.frame_count, bytes);
  PointRecording recording;
  recording.points = distinct_point_names(std::move(take.points), take.notes);
  recording.frames_per_second = timing.frames_per_second;
  const std::size_t cells = static_cast<std::size_t>(timing.frame_count) * points;
  recording.positions.assign(cells, Vec3::Zero());
  recording.seen.assign(cells, false);
  std::vector<Keypoint> found(points);
  for (std::size_t m = 0; m < take.moments.size(); ++m) {
    if (take.moments[m] == nullptr) continue;
    std::ranges::fill(found, Keypoint{});
    take.read_points(*take.moments[m], m, found);
    const std::size_t start = static_cast<std::size_t>(timing.frame_of[m]) * points;
    for (std::size_t p = 0; p < points; ++p) {
      if (!found[p].is_seen) continue;
      recording.positions[start + p] = found[p].position;
      recording.seen[start + p] = true;
    }
  }
  recording.format = std::move(take.format);
  recording.unit = std::move(take.unit);
  recording.metres_per_unit = take.metres_per_unit;
  recording.subjects = std::move(take.subjects);
  recording.subject = std::move(take.subject);
  recording.notes = std::move(take.notes);
  recording.notes.insert(recording.notes.end(), timing.notes.begin(), timing.notes.end());
  return recording;
}

}  // namespace

void choose_person(const PeopleOfFrames& people, const KeypointFile& file, KeypointTake& take) {
  std::unordered_map<std::string, std::size_t> index_of;
  for (const auto& in_frame : people)
    for (const KeypointPerson& person : in_frame)
      if (index_of.emplace(person.name, take.subjects.size()).second)
        take.subjects.push_back(person.name);
  if (take.subjects.empty())
    throw Error({file.name}, "nobody is found in any frame", known_layouts);
  const std::size_t chosen = chosen_subject({file.name}, take.subjects, file.options.subject);
  take.subject = take.subjects[chosen];
  if (const std::string note = note_on_subject(take.subjects, chosen, file.options.subject);
      !note.empty())
    take.notes.push_back(note);
  for (const auto& in_frame : people) {
    const auto found = std::ranges::find(in_frame, take.subject, &KeypointPerson::name);
    take.moments.push_back(found == in_frame.end() ? nullptr : found->points);
  }
}

std::optional<double> coordinate(const Json* value, const KeypointFile& file, std::size_t frame) {
  if (value == nullptr || value->is_null()) return std::nullopt;
  if (value->is_string() && value->get_ref<const std::string&>().empty()) return std::nullopt;
  if (value->is_number() && std::abs(value->get<double>()) < 1e12) return value->get<double>();
  throw Error({file.name},
              "a coordinate of frame " + std::to_string(frame + 1) + " is not a usable number",
              "write numbers, or null for what is missing");
}

std::vector<std::string> names_for(std::size_t count, const std::vector<std::string>& known,
                                   const KeypointFile& file) {
  const std::vector<std::string> given = given_point_names(file.options.joints);
  if (!given.empty() && given.size() != count)
    throw Error({file.name},
                std::to_string(given.size()) + " names of points are given, but it holds " +
                    std::to_string(count) + " points",
                "name the points in the order of the file");
  if (!given.empty()) return given;
  if (known.size() == count) return known;
  throw Error({file.name}, "holds " + std::to_string(count) + " points without names",
              std::string("list the names of the points with ") + joints_option);
}

void refuse_flat(const KeypointFile& file, const std::string& what) {
  throw Error({file.name},
              "holds two-dimensional keypoints only (" + what + "), which are not read",
              "give positions in space, as from several cameras or as world landmarks");
}

void require_keypoint_bytes(std::size_t bytes, const std::string& file) {
  if (bytes <= max_keypoint_bytes) return;
  throw Error({file},
              "has more than the " + std::to_string(max_keypoint_bytes >> 20) +
                  " MiB of keypoints that can be read",
              "cut the recording into shorter files, or write it as CSV");
}

PointRecording recording_of_frames(const KeypointFile& file, std::vector<std::int64_t> numbers,
                                   std::size_t bytes) {
  KeypointTake take = take_of(file);
  take.times.numbers = std::move(numbers);
  return recording_of(std::move(take), file, bytes, "file");
}

PointRecording parse_keypoints(std::string_view json, const std::string& file_name,
                               const ReadOptions& options) {
  require_keypoint_bytes(json.size(), file_name);
  const Json parsed = parse_json_text(json, file_name, "keypoints");
  const KeypointFile file{parsed, file_name, options};
  PointRecording recording = recording_of(take_of(file), file, json.size(), "frame");
  recording.name = recording_name(file_name);
  return recording;
}

PointRecording read_keypoints(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code unknown;
  if (frame_file_name(path) || std::filesystem::is_directory(path, unknown))
    return read_keypoint_files(path, options);
  const std::string file = path.string();
  const std::string bytes = read_contents(path);
  const std::size_t first = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  const bool is_object = first != std::string::npos && bytes[first] == '{';
  if (!is_object) require_kind(bytes, file, "json");
  return parse_keypoints(bytes, file, options);
}

}  // namespace mien::motion
