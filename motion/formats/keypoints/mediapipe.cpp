#include <array>

#include "motion/formats/keypoints/keypoint_names.h"
#include "motion/formats/keypoints/keypoint_take.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;

/// Names under which programs write the landmarks of a frame; those in space first.
constexpr std::array<const char*, 6> world_keys = {"pose_world_landmarks", "poseWorldLandmarks",
                                                   "world_landmarks",      "worldLandmarks",
                                                   "keypoints3D",          "keypoints_3d"};
constexpr std::array<const char*, 3> picture_keys = {"pose_landmarks", "poseLandmarks",
                                                     "landmarks"};

enum class Space { unknown, world, picture };

/// A list of landmarks, or of such a list for each person.
struct Landmarks {
  const Json* list = nullptr;
  Space space = Space::unknown;
};

bool is_landmark(const Json& value) {
  if (value.is_object()) return value.contains("x");
  return value.is_array() && value.size() >= 2 && value.size() <= 5 && !value[0].is_structured();
}

/// The list of a protocol buffer, as some programs write it, or the value itself.
const Json& unwrapped(const Json& value) {
  const auto inner = value.is_object() ? value.find("landmark") : value.end();
  return value.is_object() && inner != value.end() ? *inner : value;
}

Landmarks landmarks_of(const Json& frame) {
  if (frame.is_array()) return {&frame, Space::unknown};
  if (!frame.is_object()) return {};
  const auto with_key = [&](const auto& keys, Space space) -> Landmarks {
    for (const char* const key : keys) {
      const auto found = frame.find(key);
      if (found == frame.end()) continue;
      const Json& list = unwrapped(*found);
      if (list.is_array() && !list.empty()) return {&list, space};
    }
    return {};
  };
  const Landmarks in_world = with_key(world_keys, Space::world);
  if (in_world.list != nullptr) return in_world;
  const auto inner = frame.find("landmark");
  if (inner != frame.end()) return {&*inner, Space::unknown};
  return with_key(picture_keys, Space::picture);
}

std::vector<KeypointPerson> people_in(const Landmarks& landmarks) {
  if (landmarks.list == nullptr || landmarks.list->empty()) return {};
  if (is_landmark(landmarks.list->front())) return {{"person 1", landmarks.list}};
  std::vector<KeypointPerson> people;
  for (std::size_t i = 0; i < landmarks.list->size(); ++i) {
    const Json& list = unwrapped((*landmarks.list)[i]);
    if (list.is_array() && !list.empty() && is_landmark(list.front()))
      people.push_back({"person " + std::to_string(i + 1), &list});
  }
  return people;
}

const Json* part(const Json& landmark, std::size_t axis) {
  constexpr std::array<const char*, 3> keys = {"x", "y", "z"};
  if (landmark.is_array()) return axis < landmark.size() ? &landmark[axis] : nullptr;
  const auto found = landmark.find(keys[axis]);
  return found == landmark.end() ? nullptr : &*found;
}

void read_points(const Json& list, const KeypointFile& file, std::size_t frame,
                 std::span<Keypoint> points) {
  if (list.size() != points.size())
    throw Error({file.name},
                "frame " + std::to_string(frame + 1) + " has " + std::to_string(list.size()) +
                    " landmarks, not " + std::to_string(points.size()),
                "give the same landmarks in all frames");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_landmark(list[i])) {
      if (list[i].is_null()) continue;
      throw Error(
          {file.name},
          "frame " + std::to_string(frame + 1) + " has no landmark at " + std::to_string(i + 1),
          "give x, y and z of each landmark, or null");
    }
    points[i].is_seen = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = coordinate(part(list[i], axis), file, frame);
      points[i].is_seen &= value.has_value();
      points[i].position[static_cast<Eigen::Index>(axis)] = value.value_or(0.0);
    }
  }
}

/// The names that the landmarks state, if all do; otherwise those of the pose.
std::vector<std::string> names_of(const Json& list, const KeypointFile& file) {
  std::vector<std::string> names;
  for (const Json& landmark : list) {
    const auto name = landmark.is_object() ? landmark.find("name") : landmark.end();
    const bool is_named = landmark.is_object() && name != landmark.end() && name->is_string();
    if (!is_named) return names_for(list.size(), mediapipe_pose_names(), file);
    names.push_back(name->get<std::string>());
  }
  return names;
}

void add_unit(Space space, KeypointTake& take) {
  if (space == Space::world) {
    take.unit = "m";
    take.metres_per_unit = 1.0;
  }
  if (space == Space::picture)
    take.notes.emplace_back(
        "The landmarks are those of the picture: their x, y and z are not to one scale. World "
        "landmarks are better.");
}

}  // namespace

KeypointTake mediapipe_take(const std::vector<const Json*>& frames, const KeypointFile& file) {
  PeopleOfFrames people;
  Space space = Space::unknown;
  for (const Json* const frame : frames) {
    const Landmarks landmarks = landmarks_of(*frame);
    people.push_back(people_in(landmarks));
    if (people.back().empty()) continue;
    if (space != Space::unknown && landmarks.space != space)
      throw Error({file.name}, "some frames have world landmarks, others have not",
                  "give the same landmarks in all frames");
    space = landmarks.space;
  }
  KeypointTake take;
  take.format = "mediapipe";
  choose_person(people, file, take);
  const Json* first = nullptr;
  for (const Json* const list : take.moments)
    if (first == nullptr) first = list;
  if (part(first->front(), 2) == nullptr) refuse_flat(file, "landmarks without z");
  take.points = names_of(*first, file);
  add_unit(space, take);
  take.read_points = [file](const Json& list, std::size_t frame, std::span<Keypoint> points) {
    read_points(list, file, frame, points);
  };
  return take;
}

}  // namespace mien::motion
