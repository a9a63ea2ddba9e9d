#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "motion/formats/numpy/array_rate.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

const NpyArray& markers_in(const Npz& npz) {
  const NpyArray* const array = find_array(npz, "marker_data");
  if (!array)
    throw Error({npz.file}, "holds no markers: it has no array marker_data",
                "name an AMASS file with markers");
  require_readable(*array, {npz.file});
  if (array->shape.size() != 3 || array->shape[2] != 3 || array->size() == 0)
    throw Error(
        {npz.file},
        described(*array) + " has the shape " + excerpt(shape_text(*array)) + ", not T × M × 3",
        "save the position of each marker in each frame");
  require_reasonable_size({npz.file}, array->shape[1], array->shape[0]);
  return *array;
}

std::vector<std::string> labels_in(const Npz& npz, std::size_t count) {
  const NpyArray* const array = find_array(npz, "marker_labels");
  std::vector<std::string> labels(count);
  if (!array) return labels;
  labels = texts_of(*array, {npz.file});
  if (labels.size() == count) return labels;
  throw Error({npz.file},
              described(*array) + " holds " + std::to_string(labels.size()) + " names for " +
                  std::to_string(count) + " markers",
              "save a name for each marker");
}

/// `base`, or `base` and the next number after `number` that makes it a new name.
std::string new_name(const std::string& base, int& number, std::set<std::string>& taken) {
  std::string name = base;
  while (!taken.insert(name).second) name = base + " " + std::to_string(++number);
  return name;
}

/// Names that all differ, and none is empty.
std::vector<std::string> distinct(std::vector<std::string> names) {
  std::set<std::string> taken(names.begin(), names.end());
  std::map<std::string, int> numbers;  // of the names that were met
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string& name = names[i];
    const bool is_empty = name.empty();
    if (is_empty) name = "marker_" + std::to_string(i + 1);
    const auto [number, is_first] = numbers.try_emplace(is_empty ? "" : name, 1);
    if (is_empty) number->second = 1;
    if (is_empty || !is_first) name = new_name(name, number->second, taken);
  }
  return names;
}

WantedArrays marker_arrays() {
  std::vector<std::string_view> wanted = rate_array_names();
  wanted.insert(wanted.end(), {"marker_data", "marker_labels"});
  return wanted;
}

PointRecording smpl_markers(const Npz& npz, const ReadOptions& options) {
  PointRecording recording;
  recording.name = recording_name(npz.file);
  recording.format = "smpl";
  const NpyArray& markers = markers_in(npz);
  recording.points = distinct(labels_in(npz, markers.shape[1]));
  const std::optional<double> rate = rate_of_arrays(npz, options);
  if (!rate) throw no_rate(npz.file);
  recording.frames_per_second = *rate;
  const std::vector<double> numbers = numbers_of(markers, {npz.file});
  recording.positions.assign(numbers.size() / 3, Vec3::Zero());
  recording.seen.assign(numbers.size() / 3, false);
  for (std::size_t i = 0; i < recording.positions.size(); ++i) {
    const Vec3 position(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    if (position.isZero(0.0) || !(position.cwiseAbs().maxCoeff() < 1e12)) continue;
    recording.positions[i] = position;
    recording.seen[i] = true;
  }
  return recording;
}

}  // namespace

PointRecording parse_smpl_markers(std::string_view bytes, const std::string& file_name,
                                  const ReadOptions& options) {
  return smpl_markers(parse_npz(bytes, file_name, marker_arrays()), options);
}

PointRecording read_smpl_markers(const std::filesystem::path& path, const ReadOptions& options) {
  return smpl_markers(read_npz(path, marker_arrays()), options);
}

}  // namespace mien::motion
