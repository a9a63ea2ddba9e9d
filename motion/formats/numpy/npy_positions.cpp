#include "motion/formats/numpy/npy_positions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "motion/formats/numpy/array_rate.h"
#include "motion/formats/numpy/npy_description.h"
#include "motion/formats/numpy/npz.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/points/joint_orders.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/result_file.h"

namespace mien::motion {

namespace {

constexpr std::string_view save_positions =
    "save the positions of J joints in T frames as an array of T × J × 3";
constexpr std::size_t humanml3d_joints = 22;
constexpr double humanml3d_rate = 20.0;
constexpr std::string_view name_arrays[] = {"names",         "joint_names",  "labels",
                                            "marker_labels", "marker_names", "keypoints"};

/// Frames, joints and coordinates, without leading extents of 1.
struct Extents {
  std::size_t frames = 0;
  std::size_t joints = 0;
};

std::optional<Extents> extents_of(const NpyArray& array) {
  std::span<const std::size_t> shape = array.shape;
  while (shape.size() > 3 && shape.front() == 1) shape = shape.subspan(1);
  if (shape.size() != 3 || shape[2] != 3 || shape[0] == 0 || shape[1] == 0) return std::nullopt;
  return Extents{shape[0], shape[1]};
}

[[noreturn]] void refuse_shape(const NpyArray& array, const std::string& file) {
  const std::vector<std::size_t>& shape = array.shape;
  const std::string has_shape =
      described(array) + " has the shape " + excerpt(shape_text(array)) + ", which is ";
  const bool is_table = shape.size() == 2;
  if (is_table && (shape[1] == 263 || shape[1] == 251)) {
    const bool is_humanml3d = shape[1] == 263;
    throw Error({file},
                has_shape + "that of " + (is_humanml3d ? "HumanML3D" : "KIT-ML") +
                    " features, not of positions",
                std::string("recover the joints with recover_from_ric(data, ") +
                    (is_humanml3d ? "22" : "21") + ") of HumanML3D, and save those");
  }
  if (shape.size() >= 3 && shape.back() == 2)
    throw Error({file}, has_shape + "that of positions in the picture plane (2-D)",
                "reconstruct the motion in 3-D first");
  throw Error({file}, has_shape + "not T × J × 3", save_positions);
}

/// The only array of T × J × 3 of an .npz file.
std::string positions_name(const Npz& outlines) {
  std::vector<std::string> names;
  for (const NpyArray& array : outlines.arrays)
    if (extents_of(array) && array.type.kind != 'O') names.push_back(array.name);
  if (names.size() == 1) return names.front();
  if (names.size() > 1)
    throw Error({outlines.file}, "holds several arrays of positions: " + listed(names),
                "save the one of the joints alone");
  for (const NpyArray& array : outlines.arrays) require_readable(array, {outlines.file});
  if (outlines.arrays.size() == 1) refuse_shape(outlines.arrays.front(), outlines.file);
  for (const NpyArray& array : outlines.arrays) names.push_back(array.name);
  throw Error({outlines.file}, "holds no array of positions, T × J × 3, but " + listed(names),
              save_positions);
}

/// The array of positions in an .npz file, then the rates and names. `read` gives the wanted
/// arrays.
template <class Read>
Npz npz_positions(Read read) {
  const std::string name = positions_name(read(WantedArrays(std::in_place)));
  std::vector<std::string_view> wanted = rate_array_names();
  wanted.push_back(name);
  wanted.insert(wanted.end(), std::begin(name_arrays), std::end(name_arrays));
  Npz npz = read(wanted);
  const auto found = std::find_if(npz.arrays.begin(), npz.arrays.end(),
                                  [&](const NpyArray& array) { return array.name == name; });
  std::iter_swap(npz.arrays.begin(), found);
  return npz;
}

/// How much the bones of an order change their length over the frames, and how long they are:
/// standard deviation and mean, summed over the bones.
struct BoneLengths {
  double change = 0.0;
  double length = 0.0;
};

BoneLengths bone_lengths(const PointRecording& recording, std::size_t joints,
                         const JointOrder& order) {
  BoneLengths sum;
  for (const auto& [from, to] : order.bones) {
    double count = 0.0;
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t t = 0; t < recording.positions.size() / joints; ++t) {
      const std::size_t a = t * joints + static_cast<std::size_t>(from);
      const std::size_t b = t * joints + static_cast<std::size_t>(to);
      if (!recording.seen[a] || !recording.seen[b]) continue;
      const double length = (recording.positions[a] - recording.positions[b]).norm();
      count += 1.0;
      const double before = mean;
      mean += (length - before) / count;
      square += (length - before) * (length - mean);
    }
    if (count == 0.0) continue;
    sum.change += std::sqrt(square / count);
    sum.length += mean;
  }
  return sum;
}

/// The order of 25 joints whose bones are clearly the shorter, and not the less constant.
const JointOrder* order_by_bones(const PointRecording& recording) {
  const JointOrder* const kinect = joint_order("kinect");
  const JointOrder* const openpose = joint_order("body_25");
  const BoneLengths of_kinect = bone_lengths(recording, 25, *kinect);
  const BoneLengths of_openpose = bone_lengths(recording, 25, *openpose);
  const auto fits_better = [](const BoneLengths& a, const BoneLengths& b) {
    return a.length < 0.75 * b.length && a.change <= b.change;
  };
  if (fits_better(of_kinect, of_openpose)) return kinect;
  return fits_better(of_openpose, of_kinect) ? openpose : nullptr;
}

const JointOrder* order_by_count(const PointRecording& recording, std::size_t joints) {
  if (joints == 25) return order_by_bones(recording);
  for (const JointOrder& order : joint_orders())
    if (order.joints.size() == joints) return &order;
  return nullptr;
}

/// The names of the joints that stand beside their positions; empty if there are none.
std::vector<std::string> stated_names(const Npz& npz, std::size_t joints) {
  for (const std::string_view name : name_arrays) {
    const NpyArray* const array = find_array(npz, name);
    if (!array || array->size() != joints || (array->type.kind != 'U' && array->type.kind != 'S'))
      continue;
    std::vector<std::string> names = texts_of(*array, {npz.file});
    const std::set<std::string> distinct(names.begin(), names.end());
    if (distinct.size() == joints && !distinct.contains("")) return names;
  }
  return {};
}

void set_names(PointRecording& recording, std::size_t joints, const Npz& npz,
               const ReadOptions& options) {
  const std::string& file = npz.file;
  const std::vector<std::string>& given = options.joints;
  const JointOrder* const named = given.size() == 1 ? joint_order(given.front()) : nullptr;
  if (!given.empty() && !named) {
    const bool all_differ =
        std::set<std::string>(given.begin(), given.end()).size() == given.size();
    if (given.size() != joints || !all_differ || std::count(given.begin(), given.end(), "") > 0)
      throw Error({file},
                  std::to_string(given.size()) +
                      " names of joints are given, but the array holds " + std::to_string(joints) +
                      " joints, each of which needs a name of its own",
                  "name the joints in the order of the array");
    recording.points = given;
    return;
  }
  if (given.empty()) recording.points = stated_names(npz, joints);
  if (!recording.points.empty()) return;
  const JointOrder* const order = named ? named : order_by_count(recording, joints);
  if (!order)
    throw Error({file}, "the order of its " + std::to_string(joints) + " joints is not known",
                std::string("list their names, in the order of the array, or name a known order "
                            "(humanml3d, smpl, h36m, kinect, body_25, mediapipe), with ") +
                    joints_option);
  if (order->joints.size() != joints)
    throw Error({file},
                "the order " + std::string(order->name) + " has " +
                    std::to_string(order->joints.size()) + " joints, but the array holds " +
                    std::to_string(joints),
                "list the names of the joints in the order of the array");
  recording.points.assign(order->joints.begin(), order->joints.end());
  if (!named)
    recording.notes.push_back("The order of the " + std::to_string(joints) +
                              " joints is taken to be that of " + std::string(order->name) +
                              "; another can be named with " + joints_option + ".");
}

void set_rate(PointRecording& recording, bool is_taken_as_humanml3d, const Npz& npz,
              const ReadOptions& options) {
  std::optional<double> rate = rate_of_arrays(npz, options);
  if (!rate && is_taken_as_humanml3d) {
    rate = humanml3d_rate;
    recording.notes.push_back(
        "The file does not state its frame rate: 20 Hz, that of HumanML3D, is used.");
  }
  if (!rate) throw no_rate(npz.file);
  recording.frames_per_second = *rate;
}

/// The positions of the first array.
PointRecording positions_of(const Npz& npz, const ReadOptions& options) {
  const std::string& file_name = npz.file;
  const NpyArray& array = npz.arrays.front();
  const std::optional<Extents> extents = extents_of(array);
  if (!extents) refuse_shape(array, file_name);
  require_reasonable_size({file_name}, extents->joints, extents->frames);
  PointRecording recording;
  recording.name = recording_name(file_name);
  recording.format = "npy";
  const std::vector<double> numbers = numbers_of(array, {file_name});
  recording.positions.assign(numbers.size() / 3, Vec3::Zero());
  recording.seen.assign(numbers.size() / 3, false);
  for (std::size_t i = 0; i < recording.positions.size(); ++i) {
    const Vec3 position(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    if (position.hasNaN()) continue;
    if (position.cwiseAbs().maxCoeff() > 1e12)
      throw Error({file_name},
                  described(array) + " holds a number in frame " +
                      std::to_string(i / extents->joints + 1) + " that is too large",
                  "save what is missing as NaN");
    recording.positions[i] = position;
    recording.seen[i] = true;
  }
  const bool is_taken_as_humanml3d = extents->joints == humanml3d_joints &&
                                     options.joints.empty() &&
                                     stated_names(npz, extents->joints).empty();
  set_names(recording, extents->joints, npz, options);
  set_rate(recording, is_taken_as_humanml3d, npz, options);
  if (is_taken_as_humanml3d) {
    recording.unit = "m";
    recording.metres_per_unit = 1.0;
  }
  return recording;
}

/// As described beside the file, except for names that the options give.
PointRecording described_positions(NpyArray array, const std::string& file,
                                   const NpyDescription& description, ReadOptions options) {
  const std::optional<Extents> extents = extents_of(array);
  if (extents && extents->joints != description.points.size())
    throw Error({description.file},
                "names " + std::to_string(description.points.size()) +
                    " points, but the array holds " + std::to_string(extents->joints),
                "put the description of this file beside it, or remove it");
  if (options.joints.empty()) options.joints = description.points;
  options.frames_per_second = description.frames_per_second;
  PointRecording recording = positions_of({file, {std::move(array)}}, options);
  recording.unit = description.unit;
  recording.metres_per_unit = description.unit.empty() ? 0.0 : 1.0;
  recording.notes.push_back("The description beside the file says what its points are.");
  return recording;
}

}  // namespace

PointRecording parse_npy_positions(std::string_view bytes, const std::string& file_name,
                                   const ReadOptions& options) {
  if (!bytes.starts_with("PK"))
    return positions_of({file_name, {parse_npy(bytes, file_name)}}, options);
  return positions_of(npz_positions([&](const WantedArrays& wanted) {
                        return parse_npz(bytes, file_name, wanted);
                      }),
                      options);
}

PointRecording read_npy_positions(const std::filesystem::path& path, const ReadOptions& options) {
  NpyArray array = read_npy(path);
  if (const auto description = read_npy_description(path))
    return described_positions(std::move(array), path.string(), *description, options);
  return positions_of({path.string(), {std::move(array)}}, options);
}

PointRecording read_npz_positions(const std::filesystem::path& path, const ReadOptions& options) {
  return positions_of(
      npz_positions([&](const WantedArrays& wanted) { return read_npz(path, wanted); }), options);
}

std::string to_positions_npy(const PointRecording& recording) {
  const double metres = recording.metres_per_unit > 0.0 ? recording.metres_per_unit : 1.0;
  std::vector<double> numbers;
  numbers.reserve(3 * recording.positions.size());
  for (std::size_t i = 0; i < recording.positions.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      numbers.push_back(recording.seen[i] ? recording.positions[i][axis] * metres : NAN);
  const auto frames = static_cast<std::size_t>(recording.frame_count());
  return to_npy(array_of_floats(numbers, {frames, recording.points.size(), 3}));
}

}  // namespace mien::motion
