#include <array>
#include <filesystem>
#include <optional>

#include "motion/formats/numpy/array_rate.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/formats/smpl/smpl_model.h"
#include "motion/formats/smpl/smpl_rotations.h"
#include "motion/math/rotation.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::array<std::string_view, 2> root_path_names = {"trans", "transl"};

WantedArrays motion_arrays() {
  std::vector<std::string_view> names = smpl_rotation_arrays();
  for (const std::string_view name : rate_array_names()) names.push_back(name);
  names.insert(names.end(), root_path_names.begin(), root_path_names.end());
  names.insert(names.end(), {"betas", "gender"});
  return names;
}

double rate_of(const Npz& npz, const ReadOptions& options) {
  if (const std::optional<double> rate = rate_of_arrays(npz, options)) return *rate;
  throw no_rate(npz.file);
}

/// T × 3 numbers; empty without such an array.
std::vector<double> root_path(const Npz& npz, std::size_t frames, std::vector<std::string>& notes) {
  for (const std::string_view name : root_path_names) {
    const NpyArray* const array = find_array(npz, name);
    if (!array) continue;
    if (array->shape != std::vector<std::size_t>{frames, 3})
      throw Error({npz.file},
                  described(*array) + " has the shape " + excerpt(shape_text(*array)) + ", not (" +
                      std::to_string(frames) + ", 3) as for the " + std::to_string(frames) +
                      " frames of rotations",
                  "save arrays of the same number of frames");
    std::vector<double> numbers = numbers_of(*array, {npz.file});
    require_finite(*array, numbers, npz.file);
    return numbers;
  }
  notes.push_back("The file holds no translation (trans): the figure stays in place.");
  return {};
}

/// The person's shape coefficients: one row, or one for each frame, of which the first counts.
std::vector<double> betas_of(const Npz& npz, std::vector<std::string>& notes) {
  const NpyArray* const array = find_array(npz, "betas");
  if (!array || array->type.kind == 'O') return {};
  std::vector<double> betas = numbers_of(*array, {npz.file});
  require_finite(*array, betas, npz.file);
  if (array->shape.size() == 2 && array->shape[0] > 0) {
    betas.resize(array->shape[1]);
    if (array->shape[0] > 1)
      notes.push_back(
          "The file holds shape coefficients (betas) for every frame; those of the "
          "first are used.");
  }
  return betas;
}

std::string gender_of(const Npz& npz) {
  const NpyArray* const array = find_array(npz, "gender");
  if (!array || (array->type.kind != 'U' && array->type.kind != 'S')) return "";
  const std::vector<std::string> texts = texts_of(*array, {npz.file});
  return texts.empty() ? "" : texts.front();
}

void note_body(const Npz& npz, const std::vector<double>& betas, const ReadOptions& options,
               std::vector<std::string>& notes) {
  const std::string gender = gender_of(npz);
  const std::string person =
      gender.empty() ? "" : " The file states the gender: " + excerpt(gender) + ".";
  if (!options.body_model.empty()) {
    notes.push_back("The body has the proportions of the model " +
                    in_quotes(options.body_model.filename().string()) + " for " +
                    std::to_string(betas.size()) + " shape coefficients (betas)." + person);
    return;
  }
  notes.push_back(
      "The body is mien's own, 1.75 m tall with its soles: the person's proportions are not in the "
      "file." +
      person);
}

Vec3 vector_at(const std::vector<double>& numbers, std::size_t index) {
  return {numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]};
}

void set_takes(const Npz& npz, const ReadOptions& options, Recording& recording) {
  const bool has_markers = find_array(npz, "marker_data") != nullptr;
  if (options.take && (*options.take != smpl_body_take || !has_markers)) {
    throw Error({npz.file}, "there is no take " + in_quotes(*options.take),
                has_markers ? "choose body or markers" : "omit the take");
  }
  if (!has_markers) return;
  recording.takes = {std::string(smpl_body_take), std::string(smpl_markers_take)};
  recording.take = smpl_body_take;
}

Recording smpl_motion(const Npz& npz, const ReadOptions& options) {
  Recording recording;
  set_takes(npz, options, recording);
  recording.name = recording_name(npz.file);
  recording.format = "smpl";
  const SmplRotations rotations = smpl_rotations(npz, recording.notes);
  recording.frames_per_second = rate_of(npz, options);
  const std::vector<double> path = root_path(npz, rotations.frames, recording.notes);
  const std::vector<double> betas = betas_of(npz, recording.notes);
  recording.skeleton = smpl_skeleton(rotations.joints);
  if (!options.body_model.empty())
    set_smpl_proportions(recording.skeleton, options.body_model, betas);
  note_body(npz, betas, options, recording.notes);
  const Vec3 pelvis = recording.skeleton.joints.front().offset;
  recording.poses.resize(rotations.frames);
  std::size_t joint = 0;
  for (std::size_t t = 0; t < rotations.frames; ++t) {
    Pose& pose = recording.poses[t];
    pose.root_position = pelvis;
    if (!path.empty()) pose.root_position += vector_at(path, t);
    pose.rotations.reserve(rotations.joints);
    for (std::size_t j = 0; j < rotations.joints; ++j)
      pose.rotations.push_back(exp(vector_at(rotations.axis_angles, joint++)));
  }
  return recording;
}

}  // namespace

bool holds_smpl_motion(const std::filesystem::path& path) {
  return has_smpl_rotations(read_npz(path, WantedArrays(std::in_place)));
}

bool holds_smpl_motion(std::string_view bytes, const std::string& file_name) {
  return has_smpl_rotations(parse_npz(bytes, file_name, WantedArrays(std::in_place)));
}

Recording read_smpl(const std::filesystem::path& path, const ReadOptions& options) {
  return smpl_motion(read_npz(path, motion_arrays()), options);
}

Recording parse_smpl(std::string_view bytes, const std::string& file_name,
                     const ReadOptions& options) {
  return smpl_motion(parse_npz(bytes, file_name, motion_arrays()), options);
}

}  // namespace mien::motion
