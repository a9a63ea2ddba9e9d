#include "motion/formats/motion_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "motion/error.h"
#include "motion/formats/acclaim/acclaim.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/formats/c3d/c3d.h"
#include "motion/formats/fbx/fbx.h"
#include "motion/formats/fitted_file.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/keypoints/keypoints.h"
#include "motion/formats/motion_format.h"
#include "motion/formats/mvnx/mvnx.h"
#include "motion/formats/numpy/npy_description.h"
#include "motion/formats/numpy/npy_positions.h"
#include "motion/formats/reading/given_rate.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/formats/table/bids_motion.h"
#include "motion/formats/table/point_table.h"
#include "motion/formats/table/tidy_csv.h"
#include "motion/formats/trc/trc.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

using std::filesystem::path;

// Of recordings, frames per second.
constexpr double least_rate = 0.1;
constexpr double greatest_rate = 10000.0;

FileContents read_gltf_file(const path& file, const ReadOptions& how) {
  return read_gltf(file, how.take, how.subject, how.frames_per_second);
}

// Theia's files hold rotations instead of points.
FileContents read_c3d_file(const path& file, const ReadOptions& how) {
  const std::string bytes = read_contents(file);
  require_kind(bytes, file.string(), "c3d");
  if (holds_c3d_rotations(bytes)) return parse_c3d_rotations(bytes, file.string(), how);
  return parse_c3d(bytes, file.string(), how);
}

[[noreturn]] void refuse_names(const path& file) {
  throw Error({file.string()}, "has names of its joints or points, so none can be given",
              "omit the names of joints");
}

[[noreturn]] void refuse_body_model(const path& file) {
  throw Error({file.string()}, "holds no rotations of SMPL joints, so no body model can be used",
              "omit the body model");
}

FileContents read_npz_file(const path& file, const ReadOptions& how) {
  const bool is_smpl = holds_smpl_motion(file);
  const bool are_markers = is_smpl && how.take == smpl_markers_take;
  if (is_smpl && !how.joints.empty()) refuse_names(file);
  if ((!is_smpl || are_markers) && !how.body_model.empty()) refuse_body_model(file);
  if (are_markers) return read_smpl_markers(file, how);
  if (is_smpl) return read_smpl(file, how);
  if (how.take) {
    throw Error({file.string()}, "holds one motion, so no take can be chosen", "omit the take");
  }
  return read_npz_positions(file, how);
}

FileContents read_tsv_file(const path& file, const ReadOptions& how) {
  if (is_bids_motion(file)) return read_bids_motion(file, how);
  return read_point_table(file, how);
}

template <auto reader>
FileContents read_with(const path& file, const ReadOptions& how) {
  return reader(file, how);
}

Recording read_amc_file(const path& file, const ReadOptions& how) {
  return read_amc(file, {.frames_per_second = how.frames_per_second});
}

Recording read_bvh_file(const path& file, const ReadOptions& how) { return read_bvh(file, how); }

std::vector<std::string> trc_bytes(const PointRecording& points, const PointFile&) {
  return {to_trc(points)};
}

std::vector<std::string> npy_bytes(const PointRecording& points, const PointFile& file) {
  return {to_positions_npy(points), npy_description(points, file.axes)};
}

std::vector<std::string> csv_bytes(const PointRecording& points, const PointFile& file) {
  return {to_tidy_csv(points), tidy_csv_sidecar(points, file.axes)};
}

std::vector<std::string> bids_bytes(const PointRecording& points, const PointFile& file) {
  return bids_motion_texts(points, file.name);
}

constexpr MotionFormat formats[] = {
    {.ending = ".bvh",
     .name = "BVH",
     .has_subjects = true,
     .is_streamed = true,
     .read = read_with<read_bvh_file>,
     .bytes_of_motion = to_bvh},
    {.ending = ".amc", .name = "Acclaim", .part_ending = ".asf", .read = read_with<read_amc_file>},
    {.ending = ".fbx",
     .name = "FBX",
     .has_takes = true,
     .has_subjects = true,
     .read = read_with<read_fbx>},
    {.ending = ".gltf",
     .name = "glTF",
     .part_ending = ".bin",
     .has_takes = true,
     .has_subjects = true,
     .read = read_gltf_file},
    {.ending = ".glb",
     .name = "glTF",
     .has_takes = true,
     .has_subjects = true,
     .is_metric = true,
     .read = read_gltf_file,
     .bytes_of_motion = to_glb},
    {.ending = ".vrma",
     .name = "VRM",
     .has_takes = true,
     .has_subjects = true,
     .read = read_gltf_file},
    {.ending = ".vrm",
     .name = "VRM",
     .has_takes = true,
     .has_subjects = true,
     .read = read_gltf_file},
    {.ending = ".mvnx", .name = "MVNX", .has_subjects = true, .read = read_with<read_mvnx>},
    {.ending = ".c3d", .name = "C3D", .has_subjects = true, .read = read_c3d_file},
    {.ending = ".trc",
     .name = "TRC",
     .has_subjects = true,
     .is_metric = true,
     .states_unit = true,
     .read = read_with<read_trc>,
     .bytes_of_points = trc_bytes},
    {.ending = ".npz",
     .name = "NumPy",
     .has_takes = true,
     .is_metric = true,
     .is_of_body = true,
     .has_nameless_points = true,
     .is_of_motions = false,
     .read = read_npz_file,
     .bytes_of_motion = to_amass_npz},
    {.ending = ".npy",
     .name = "NumPy",
     .part_ending = ".json",
     .is_metric = true,
     .has_nameless_points = true,
     .is_of_motions = false,
     .read = read_with<read_npy_positions>,
     .bytes_of_points = npy_bytes,
     .companions = {".npy.json"}},
    {.ending = ".csv",
     .name = "tables of points",
     .has_subjects = true,
     .is_metric = true,
     .has_nameless_points = true,
     .is_of_motions = false,
     .read = read_with<read_point_table>,
     .bytes_of_points = csv_bytes,
     .companions = {".csv.json"}},
    {.ending = ".tsv",
     .name = "tables of points",
     .part_ending = ".json",
     .has_subjects = true,
     .is_metric = true,
     .has_nameless_points = true,
     .is_of_motions = false,
     .read = read_tsv_file,
     .bytes_of_points = bids_bytes,
     .written_ending = "_motion.tsv",
     .companions = {"_channels.tsv", "_motion.json"},
     .require_name = require_bids_motion_name},
    {.ending = ".json",
     .name = "keypoints",
     .has_subjects = true,
     .has_nameless_points = true,
     .is_of_motions = false,
     .read = read_with<read_keypoints>},
};

std::string names_and_extensions(
    bool (*is_meant)(const MotionFormat&),
    std::string (*ending_of)(const MotionFormat&) = [](const MotionFormat& format) {
      return std::string(format.ending);
    }) {
  std::vector<std::string> parts;  // "glTF (.gltf, .glb"
  std::string_view name;
  for (const MotionFormat& format : formats) {
    if (!is_meant(format)) continue;
    if (format.name != name) parts.push_back(std::string(format.name) + " (");
    parts.back() += (format.name == name ? ", " : "") + ending_of(format);
    name = format.name;
  }
  std::string words;
  for (std::size_t i = 0; i < parts.size(); ++i)
    words += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " or ") + parts[i] + ")";
  return words;
}

/// The first motion that may belong to a skeleton, "02_01.amc" for 02.asf; empty if there is none.
std::string motion_beside(const path& skeleton) {
  std::string first;
  std::error_code failed;
  for (std::filesystem::directory_iterator entry(absolute(skeleton).parent_path(), failed), end;
       !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (lower_case_ending(name) == ".amc" && name.starts_with(recording_name(skeleton)) &&
        (first.empty() || name < first))
      first = name;
  }
  return first;
}

[[noreturn]] void refuse_format(const path& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown))
    throw Error({file.string()}, "there is no such file", "check the name");
  if (lower_case_ending(file) == ".asf") {
    const std::string motion = motion_beside(file);
    throw Error({file.string()}, "is the skeleton of Acclaim motions",
                "name the motion, " + (motion.empty() ? "a file of .amc beside it" : motion));
  }
  throw Error({file.string()}, "is not a motion file that can be read", "use " + formats_read());
}

}  // namespace

std::span<const MotionFormat> motion_formats() { return formats; }

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = without_compression(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const MotionFormat* motion_format(const std::filesystem::path& path) {
  const auto* const found =
      std::ranges::find(formats, lower_case_ending(path), &MotionFormat::ending);
  return found == std::end(formats) ? nullptr : found;
}

std::string formats_read() {
  return names_and_extensions([](const MotionFormat&) { return true; });
}

std::string formats_written() {
  return names_and_extensions([](const MotionFormat& format) { return format.is_written(); },
                              [](const MotionFormat& format) {
                                const bool is_free = format.written_ending == format.ending;
                                return (is_free ? "" : "*") + std::string(format.written_ending);
                              });
}

std::string formats_with_takes() {
  return names_and_extensions([](const MotionFormat& f) { return f.has_takes; });
}

bool is_motion_file(const std::filesystem::path& path) { return motion_format(path) != nullptr; }

bool is_found_as_motion(const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  return format != nullptr && format->is_of_motions;
}

bool may_hold_takes(const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  return format != nullptr && format->has_takes;
}

FileContents read_file(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code unknown;
  const bool is_folder = std::filesystem::is_directory(path, unknown);
  const MotionFormat* format = motion_format(is_folder ? only_keypoint_recording(path) : path);
  if (format == nullptr) refuse_format(path);
  if (options.take && !format->has_takes) {
    throw Error({path.string(), 0, 0}, "holds one motion, so no take can be chosen",
                "omit the take; only " + formats_with_takes() + " can hold several");
  }
  if (options.subject && !format->has_subjects) {
    throw Error({path.string(), 0, 0}, "holds one person, so no subject can be chosen",
                "omit the subject");
  }
  if (!options.joints.empty() && !format->has_nameless_points) refuse_names(path);
  if (!options.body_model.empty() && format->read != read_npz_file) {
    throw Error({path.string(), 0, 0}, "is no SMPL motion, so no body model can be used",
                "omit the body model; only SMPL, SMPL-H and SMPL-X motions (.npz) take one");
  }
  const double rate = options.frames_per_second.value_or(1.0);
  if (!(rate >= least_rate && rate <= greatest_rate)) {
    throw Error({path.string(), 0, 0}, "cannot have been recorded at the given frame rate",
                "give one from 0.1 to 10000 frames per second");
  }
  FileContents contents = format->read(path, options);
  std::visit([&](auto& read) { note_unused_rate(read.frames_per_second, options, read.notes); },
             contents);
  return contents;
}

Recording read_motion(const std::filesystem::path& path, const ReadOptions& options) {
  return read_fitted(path, options).recording;
}

Recording read_motion(const std::filesystem::path& path, const std::optional<std::string>& take) {
  ReadOptions options;
  options.take = take;
  return read_motion(path, options);
}

Recording read_take(const std::filesystem::path& path, const std::string& take) {
  return read_motion(path, take.empty() ? std::nullopt : std::optional(take));
}

}  // namespace mien::motion
