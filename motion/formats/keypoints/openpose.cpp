#include "motion/formats/keypoints/keypoint_names.h"
#include "motion/formats/keypoints/keypoint_take.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;

constexpr char key_3d[] = "pose_keypoints_3d";
constexpr std::size_t values_per_point = 4;  // x, y, z, confidence

const Json* list_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_array() && !found->empty() ? &*found : nullptr;
}

/// The number that OpenPose gave the person (a number or a list of one; −1: none), or else that of
/// the place in the list.
std::string person_name(const Json& person, std::size_t index) {
  const auto found = person.find("person_id");
  if (found != person.end()) {
    const Json& id = found->is_array() && found->size() == 1 ? found->front() : *found;
    if (id.is_number_unsigned() || (id.is_number_integer() && id.get<std::int64_t>() >= 0))
      return "person " + std::to_string(id.get<std::uint64_t>());
  }
  return "person " + std::to_string(index + 1);
}

/// What kinds of keypoints the file holds.
struct KindsFound {
  bool has_flat = false;
  bool has_hands_or_face = false;
};

std::vector<KeypointPerson> people_in(const Json& frame, std::size_t number,
                                      const KeypointFile& file, KindsFound& found) {
  std::vector<KeypointPerson> people;
  const auto list = frame.is_object() ? frame.find("people") : frame.end();
  if (!frame.is_object() || list == frame.end() || !list->is_array())
    throw Error({file.name}, "frame " + std::to_string(number + 1) + " has no list of people",
                "give frames as OpenPose writes them");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json& person = (*list)[i];
    if (!person.is_object()) continue;
    found.has_flat |= list_in(person, "pose_keypoints_2d") || list_in(person, "pose_keypoints");
    for (const char* const other :
         {"face_keypoints_3d", "hand_left_keypoints_3d", "hand_right_keypoints_3d"})
      found.has_hands_or_face |= list_in(person, other) != nullptr;
    if (const Json* points = list_in(person, key_3d))
      people.push_back({person_name(person, i), points});
  }
  return people;
}

void read_openpose_points(const Json& values, const KeypointFile& file, std::size_t frame,
                          std::span<Keypoint> points) {
  if (values.size() != points.size() * values_per_point)
    throw Error({file.name},
                "frame " + std::to_string(frame + 1) + " has " + std::to_string(values.size()) +
                    " values of keypoints, not four for each of " + std::to_string(points.size()),
                "give the same points in all frames");
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_complete = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = coordinate(&values[i * values_per_point + axis], file, frame);
      is_complete &= value.has_value();
      points[i].position[static_cast<Eigen::Index>(axis)] = value.value_or(0.0);
    }
    const auto confidence = coordinate(&values[i * values_per_point + 3], file, frame);
    points[i].is_seen = is_complete && confidence.value_or(0.0) > 0.0;
  }
}

}  // namespace

KeypointTake openpose_take(const std::vector<const Json*>& frames, const KeypointFile& file) {
  PeopleOfFrames people;
  KindsFound found;
  for (std::size_t i = 0; i < frames.size(); ++i)
    people.push_back(people_in(*frames[i], i, file, found));
  std::size_t values = 0;
  for (const auto& in_frame : people)
    if (values == 0 && !in_frame.empty()) values = in_frame[0].points->size();
  if (values == 0 && found.has_flat) refuse_flat(file, "pose_keypoints_2d");
  KeypointTake take;
  take.format = "openpose";
  choose_person(people, file, take);
  const std::size_t count = values / values_per_point;
  take.points = names_for(count, count == 18 ? coco_18_names() : body_25_names(), file);
  if (found.has_hands_or_face)
    take.notes.emplace_back("Keypoints of hands and faces were left out.");
  take.read_points = [file](const Json& person, std::size_t frame, std::span<Keypoint> points) {
    read_openpose_points(person, file, frame, points);
  };
  return take;
}

}  // namespace mien::motion
