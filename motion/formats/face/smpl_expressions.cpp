#include "motion/formats/face/smpl_expressions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "motion/formats/numpy/array_rate.h"
#include "motion/formats/numpy/npz.h"

namespace mien::motion {

namespace {

constexpr std::string_view expression_arrays[] = {"expressions", "expression"};
constexpr std::string_view pose_arrays[] = {"poses", "pose"};
constexpr std::size_t most_coefficients = 1000;
constexpr std::size_t smplx_width = 165;   // numbers a frame of all rotations of SMPL-X
constexpr std::size_t first_of_face = 66;  // after the 22 joints of the body: jaw, left eye, right

/// An array of rotation vectors of the face, and of which of its joints.
struct TurnArray {
  std::string_view name;
  std::size_t first_joint;
  std::size_t joints;
};

constexpr TurnArray turn_arrays[] = {
    {"jaw_pose", 0, 1},  {"pose_jaw", 0, 1}, {"leye_pose", 1, 1},
    {"reye_pose", 2, 1}, {"pose_eye", 1, 2},
};

constexpr std::string_view turn_names[] = {"jaw_pose_", "leye_pose_", "reye_pose_"};

WantedArrays face_arrays() {
  std::vector<std::string_view> names = rate_array_names();
  names.insert(names.end(), std::begin(expression_arrays), std::end(expression_arrays));
  names.insert(names.end(), std::begin(pose_arrays), std::end(pose_arrays));
  for (const TurnArray& turns : turn_arrays) names.push_back(turns.name);
  return names;
}

const NpyArray* first_array(const Npz& npz, std::span<const std::string_view> names) {
  for (const std::string_view name : names)
    if (const NpyArray* array = find_array(npz, name)) return array;
  return nullptr;
}

std::vector<double> finite_numbers(const Npz& npz, const NpyArray& array) {
  std::vector<double> numbers = numbers_of(array, {npz.file});
  if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
    throw Error({npz.file}, described(array) + " has a number that is not finite",
                "save it without gaps");
  return numbers;
}

/// One column of an array of frames × width numbers.
FaceCurve column_of(std::string name, const std::vector<double>& numbers, std::size_t width,
                    std::size_t column, double rate) {
  FaceCurve curve{std::move(name), FaceCurve::Interpolation::linear, {}, {}};
  for (std::size_t i = column; i < numbers.size(); i += width) {
    curve.times.push_back(static_cast<double>(i / width) / rate);
    curve.values.push_back(numbers[i]);
  }
  return curve;
}

void add_expressions(const Npz& npz, const NpyArray& array, double rate, FaceTrack& track) {
  if (array.shape.size() != 2 || array.size() == 0 || array.shape[1] > most_coefficients)
    throw Error({npz.file}, described(array) + " is not of frames and up to 1000 coefficients",
                "save an array of frames × coefficients");
  const std::vector<double> numbers = finite_numbers(npz, array);
  for (std::size_t c = 0; c < array.shape[1]; ++c)
    track.push_back(column_of("exp" + std::to_string(c), numbers, array.shape[1], c, rate));
}

/// The three numbers of one joint's rotation, of those in each frame from `first` on; none if all
/// are zero.
void add_turns(const std::vector<double>& numbers, std::size_t width, std::size_t first,
               std::size_t joint, double rate, FaceTrack& track) {
  bool turns = false;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    turns = turns || (numbers[i] != 0.0 && i % width >= first && i % width < first + 3);
  for (std::size_t axis = 0; turns && axis < 3; ++axis)
    track.push_back(column_of(std::string(turn_names[joint]) + "xyz"[axis], numbers, width,
                              first + axis, rate));
}

std::size_t frame_width(const NpyArray& array) {
  return array.shape.empty() || array.shape[0] == 0 ? 0 : array.size() / array.shape[0];
}

/// Rotations of jaw and eyes, in arrays of their own or among those of all joints.
void add_all_turns(const Npz& npz, double rate, FaceTrack& track) {
  const NpyArray* poses = first_array(npz, pose_arrays);
  if (poses != nullptr && frame_width(*poses) == smplx_width) {
    const std::vector<double> numbers = finite_numbers(npz, *poses);
    for (std::size_t joint = 0; joint < std::size(turn_names); ++joint)
      add_turns(numbers, smplx_width, first_of_face + 3 * joint, joint, rate, track);
    return;
  }
  for (const TurnArray& turns : turn_arrays) {
    const NpyArray* array = find_array(npz, turns.name);
    if (array == nullptr) continue;
    const std::size_t width = 3 * turns.joints;
    if (frame_width(*array) != width)
      throw Error({npz.file},
                  described(*array) + " is not of frames and " + std::to_string(width) + " numbers",
                  "save rotation vectors of each frame");
    const std::vector<double> numbers = finite_numbers(npz, *array);
    for (std::size_t k = 0; k < turns.joints; ++k)
      add_turns(numbers, width, 3 * k, turns.first_joint + k, rate, track);
  }
}

bool has_turns(const Npz& npz) {
  const NpyArray* poses = first_array(npz, pose_arrays);
  return (poses != nullptr && frame_width(*poses) == smplx_width) ||
         std::ranges::any_of(turn_arrays, [&](const TurnArray& turns) {
           return find_array(npz, turns.name) != nullptr;
         });
}

FaceTrack track_of(const Npz& npz, std::optional<double> frames_per_second) {
  const NpyArray* expressions = first_array(npz, expression_arrays);
  if (expressions == nullptr && !has_turns(npz))
    throw Error({npz.file},
                "it has neither facial expressions (expressions) nor rotations of jaw and eyes "
                "(jaw_pose, or poses of SMPL-X)",
                "give a table of weights, or a file of SMPL-X with expressions");
  ReadOptions options;
  std::optional<double> rate = rate_of_arrays(npz, options);
  if (rate && frames_per_second)
    throw Error({npz.file}, "it states its frame rate itself", "omit fps");
  options.frames_per_second = frames_per_second;
  if (!rate) rate = rate_of_arrays(npz, options);
  if (!rate) throw no_rate(npz.file);
  FaceTrack track;
  if (expressions != nullptr) add_expressions(npz, *expressions, *rate, track);
  add_all_turns(npz, *rate, track);
  if (track.empty())
    throw Error({npz.file}, "jaw and eyes do not move in it, and it has no expressions",
                "omit face, or give a file with expressions");
  return track;
}

}  // namespace

FaceTrack parse_smpl_expressions(std::string_view bytes, const std::string& file_name,
                                 std::optional<double> frames_per_second) {
  return track_of(parse_npz(bytes, file_name, face_arrays()), frames_per_second);
}

FaceTrack read_smpl_expressions(const std::filesystem::path& path,
                                std::optional<double> frames_per_second) {
  return track_of(read_npz(path, face_arrays()), frames_per_second);
}

}  // namespace mien::motion
