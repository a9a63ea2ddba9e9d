#include <algorithm>
#include <array>
#include <unordered_map>

#include "motion/formats/keypoints/keypoint_take.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;
using IndexOf = std::unordered_map<std::string, std::size_t>;

/// Parts of a frame that hold points, in versions before `tracked_points`, with what is put before
/// the points' names.
struct Part {
  const char* key;
  const char* prefix;
};
constexpr std::array<Part, 4> parts = {{{"tracked_points", ""},
                                        {"body", ""},
                                        {"right_hand", "right_hand_"},
                                        {"left_hand", "left_hand_"}}};

/// Calls `use(name, point)` for the points of a frame.
template <class Use>
void for_each_point(const Json& frame, std::string& name, Use use) {
  if (!frame.is_object()) return;
  for (const Part& part : parts) {
    const auto found = frame.find(part.key);
    if (found == frame.end() || !found->is_object()) continue;
    for (auto point = found->begin(); point != found->end(); ++point) {
      const bool has_prefix = point.key().starts_with(part.prefix);
      name.assign(has_prefix ? "" : part.prefix);
      name += point.key();
      if (point->is_object()) use(name, *point);
    }
  }
}

struct NumberedFrame {
  std::int64_t number = 0;
  const Json* frame = nullptr;
};

/// The frames in the order of their numbers; the keys of JSON objects are sorted as texts.
std::vector<NumberedFrame> numbered_frames(const Json& by_frame, const KeypointFile& file) {
  if (!by_frame.is_object())
    throw Error({file.name}, "data_by_frame is not an object of frames", "export it again");
  std::vector<NumberedFrame> frames;
  for (auto frame = by_frame.begin(); frame != by_frame.end(); ++frame) {
    const std::optional<std::int64_t> number = as_number<std::int64_t>(frame.key());
    if (!number || *number < 0 || *number > 1'000'000'000'000)
      throw Error({file.name}, in_quotes(frame.key()) + " is not the number of a frame",
                  "export the file again");
    frames.push_back({*number, &*frame});
  }
  std::ranges::sort(frames, {}, &NumberedFrame::number);
  return frames;
}

}  // namespace

KeypointTake freemocap_take(const KeypointFile& file) {
  KeypointTake take;
  take.format = "freemocap";
  take.unit = "mm";
  take.metres_per_unit = 0.001;
  IndexOf index_of;
  std::string name;
  for (const NumberedFrame& numbered : numbered_frames(file.json["data_by_frame"], file)) {
    take.moments.push_back(numbered.frame);
    take.times.numbers.push_back(numbered.number);
    for_each_point(*numbered.frame, name, [&](const std::string& point, const Json&) {
      if (index_of.emplace(point, take.points.size()).second) take.points.push_back(point);
    });
  }
  if (take.points.empty())
    throw Error({file.name}, "data_by_frame holds no points", "export the recording again");
  take.read_points = [file, index_of = std::move(index_of)](const Json& frame, std::size_t number,
                                                            std::span<Keypoint> points) {
    std::string point_name;
    for_each_point(frame, point_name, [&](const std::string& point, const Json& value) {
      Keypoint& keypoint = points[index_of.at(point)];
      keypoint.is_seen = true;
      int axis = 0;
      for (const char* const key : {"x", "y", "z"}) {
        const auto found = value.find(key);
        const auto given = coordinate(found == value.end() ? nullptr : &*found, file, number);
        keypoint.is_seen &= given.has_value();
        keypoint.position[axis++] = given.value_or(0.0);
      }
    });
  };
  return take;
}

}  // namespace mien::motion
