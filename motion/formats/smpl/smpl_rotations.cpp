#include "motion/formats/smpl/smpl_rotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/formats/reading/recording_limits.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::array<std::string_view, 2> whole_names = {"poses", "pose"};
constexpr std::array<std::string_view, 2> root_names = {"root_orient", "global_orient"};
constexpr std::array<std::string_view, 2> body_names = {"pose_body", "body_pose"};

constexpr std::string_view save_as_amass =
    "save an array poses of T × 72 (SMPL), 156 (SMPL-H) or 165 (SMPL-X) numbers as AMASS does";

/// An array of several, and where its rotations belong.
struct PosePart {
  std::string_view name;
  std::size_t width;        ///< numbers a frame
  std::size_t smplh_joint;  ///< its first joint; 0: none
  std::size_t smplx_joint;
};

constexpr std::array<PosePart, 8> parts = {{
    {"pose_hand", 90, 22, 25},
    {"left_hand_pose", 45, 22, 25},
    {"right_hand_pose", 45, 37, 40},
    {"pose_jaw", 3, 0, 22},
    {"jaw_pose", 3, 0, 22},
    {"pose_eye", 6, 0, 23},
    {"leye_pose", 3, 0, 23},
    {"reye_pose", 3, 0, 24},
}};

const NpyArray* first_of(const Npz& npz, std::span<const std::string_view> names) {
  for (const std::string_view name : names)
    if (const NpyArray* const array = find_array(npz, name)) return array;
  return nullptr;
}

/// Numbers a frame: the product of all extents but the first.
std::size_t width_of(const NpyArray& array) {
  return array.shape.empty() || array.shape[0] == 0 ? 0 : array.size() / array.shape[0];
}

[[noreturn]] void refuse_shape(const Npz& npz, const NpyArray& array, std::string_view meaning) {
  require_readable(array, {npz.file});
  const std::size_t dimensions = array.shape.size();
  const bool is_matrices =
      dimensions == 4 && array.shape[2] == 3 && array.shape[3] == 3;  // T × J × 3 × 3
  throw Error({npz.file},
              described(array) + " has the shape " + excerpt(shape_text(array)) + ", which is " +
                  (is_matrices ? "that of rotation matrices" : std::string(meaning)),
              is_matrices ? "convert the rotations to axis-angle" : save_as_amass);
}

[[noreturn]] void refuse_layout(const Npz& npz) {
  if (const std::vector<std::string> objects = object_arrays(npz); !objects.empty()) {
    const NpyArray& array = *find_array(npz, objects.front());
    require_readable(array, {npz.file});
  }
  std::vector<std::string> names;
  for (const NpyArray& array : npz.arrays) names.push_back(array.name);
  throw Error({npz.file},
              "holds no SMPL motion: it has neither poses nor root_orient and pose_body, but " +
                  listed(names),
              save_as_amass);
}

SmplRotations whole(const Npz& npz, const NpyArray& array) {
  const std::size_t dimensions = array.shape.size();
  const std::size_t width = width_of(array);
  const bool is_table = dimensions == 2 || (dimensions == 3 && array.shape[2] == 3);
  if (!is_table || width % 3 != 0 || !is_smpl_joint_count(width / 3))
    refuse_shape(npz, array, "not T × 66, 72, 156 or 165");
  require_reasonable_size({npz.file}, width / 3, array.shape[0]);
  SmplRotations rotations{array.shape[0], width / 3, numbers_of(array, {npz.file})};
  require_finite(array, rotations.axis_angles, npz.file);
  return rotations;
}

/// Copies the numbers of one array to their place in every frame.
void put(SmplRotations& rotations, const Npz& npz, const NpyArray& array, std::size_t first_joint,
         std::size_t width) {
  if (array.shape.empty() || array.shape[0] != rotations.frames)
    throw Error({npz.file},
                described(array) + " has the shape " + excerpt(shape_text(array)) +
                    ", but there are " + std::to_string(rotations.frames) + " frames",
                "save arrays of the same number of frames");
  if (width_of(array) != width) refuse_shape(npz, array, "not T × " + std::to_string(width));
  const std::vector<double> numbers = numbers_of(array, {npz.file});
  require_finite(array, numbers, npz.file);
  for (std::size_t t = 0; t < rotations.frames; ++t)
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(t * width), width,
                rotations.axis_angles.begin() +
                    static_cast<std::ptrdiff_t>(3 * (t * rotations.joints + first_joint)));
}

bool is_hand(const PosePart& part) { return part.smplh_joint != 0; }

/// Hands as principal components need the model's own hand space.
bool is_hand_components(const PosePart& part, const NpyArray& array) {
  return is_hand(part) && array.shape.size() == 2 && width_of(array) < part.width;
}

std::size_t joints_of_parts(const Npz& npz, std::size_t body_width) {
  bool has_hands = false;
  bool has_face = false;
  for (const PosePart& part : parts) {
    const NpyArray* const array = find_array(npz, part.name);
    if (!array) continue;
    has_face = has_face || !is_hand(part);
    has_hands = has_hands || (is_hand(part) && !is_hand_components(part, *array));
  }
  if (has_face) return 55;
  return has_hands ? 52 : body_width == 69 ? 24 : 22;
}

SmplRotations assembled(const Npz& npz, const NpyArray& root, std::vector<std::string>& notes) {
  const NpyArray* const body = first_of(npz, body_names);
  if (!body) refuse_layout(npz);
  require_readable(root, {npz.file});
  require_readable(*body, {npz.file});
  const std::size_t body_width = width_of(*body);
  SmplRotations rotations;
  rotations.frames = root.shape.empty() ? 0 : root.shape[0];
  rotations.joints = joints_of_parts(npz, body_width);
  const bool fits = body_width == 63 || (body_width == 69 && rotations.joints == 24);
  if (!fits) refuse_shape(npz, *body, "not T × 63 or 69");
  if (width_of(root) != 3) refuse_shape(npz, root, "not T × 3");
  require_reasonable_size({npz.file}, rotations.joints, rotations.frames);
  rotations.axis_angles.assign(3 * rotations.frames * rotations.joints, 0.0);
  put(rotations, npz, root, 0, 3);
  put(rotations, npz, *body, 1, body_width);
  for (const PosePart& part : parts) {
    const NpyArray* const array = find_array(npz, part.name);
    if (!array) continue;
    if (is_hand_components(part, *array)) {
      notes.push_back("The array " + in_quotes(part.name) +
                      " holds principal components instead of rotations: that hand is at rest.");
      continue;
    }
    put(rotations, npz, *array, rotations.joints == 55 ? part.smplx_joint : part.smplh_joint,
        part.width);
  }
  return rotations;
}

}  // namespace

std::vector<std::string_view> smpl_rotation_arrays() {
  std::vector<std::string_view> names;
  for (const auto& some : {whole_names, root_names, body_names})
    names.insert(names.end(), some.begin(), some.end());
  for (const PosePart& part : parts) names.push_back(part.name);
  return names;
}

bool has_smpl_rotations(const Npz& npz) {
  const NpyArray* const poses = first_of(npz, whole_names);
  return poses || first_of(npz, root_names);
}

SmplRotations smpl_rotations(const Npz& npz, std::vector<std::string>& notes) {
  const NpyArray* const poses = first_of(npz, whole_names);
  const NpyArray* const root = first_of(npz, root_names);
  if (!poses && !root) refuse_layout(npz);
  SmplRotations rotations = poses ? whole(npz, *poses) : assembled(npz, *root, notes);
  if (rotations.frames == 0)
    throw Error({npz.file}, "holds no frames", "save a motion of at least one frame");
  return rotations;
}

void require_finite(const NpyArray& array, const std::vector<double>& numbers,
                    const std::string& file) {
  const auto wrong = std::find_if_not(numbers.begin(), numbers.end(),
                                      [](double number) { return std::abs(number) < 1e12; });
  if (wrong == numbers.end()) return;
  const auto frame = static_cast<std::size_t>(wrong - numbers.begin()) / width_of(array);
  throw Error({file},
              described(array) + " holds a number in frame " + std::to_string(frame + 1) +
                  " that is not finite or too large",
              "cut the frames that are not valid");
}

}  // namespace mien::motion
