#include "motion/formats/face/smpl_expressions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "motion/formats/numpy/array_rate.h"
#include "motion/formats/numpy/npz.h"

namespace mien::motion {

namespace {

constexpr std::string_view expression_arrays[] = {"expressions", "expression"};
constexpr std::size_t most_coefficients = 1000;

WantedArrays face_arrays() {
  std::vector<std::string_view> names = rate_array_names();
  names.insert(names.end(), std::begin(expression_arrays), std::end(expression_arrays));
  return names;
}

FaceTrack track_of(const Npz& npz, std::optional<double> frames_per_second) {
  const NpyArray* array = nullptr;
  for (const std::string_view name : expression_arrays)
    if (array == nullptr) array = find_array(npz, name);
  if (array == nullptr)
    throw Error({npz.file}, "it has no array of facial expressions (expressions)",
                "give a table of weights, or a file of SMPL-X with expressions");
  if (array->shape.size() != 2 || array->size() == 0 || array->shape[1] > most_coefficients)
    throw Error({npz.file}, described(*array) + " is not of frames and up to 1000 coefficients",
                "save an array of frames × coefficients");
  ReadOptions options;
  options.frames_per_second = frames_per_second;
  const std::optional<double> rate = rate_of_arrays(npz, options);
  if (!rate) throw no_rate(npz.file);
  const std::vector<double> numbers = numbers_of(*array, {npz.file});
  if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
    throw Error({npz.file}, described(*array) + " has a number that is not finite",
                "save it without gaps");
  FaceTrack track(array->shape[1]);
  for (std::size_t c = 0; c < track.size(); ++c) {
    track[c].name = "exp" + std::to_string(c);
    for (std::size_t frame = 0; frame < array->shape[0]; ++frame) {
      track[c].times.push_back(static_cast<double>(frame) / *rate);
      track[c].values.push_back(numbers[frame * track.size() + c]);
    }
  }
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
