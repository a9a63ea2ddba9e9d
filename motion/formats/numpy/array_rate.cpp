#include "motion/formats/numpy/array_rate.h"

#include <array>
#include <charconv>
#include <cmath>

#include "motion/formats/reading/frame_rate.h"
#include "motion/formats/reading/option_names.h"

namespace mien::motion {

namespace {

constexpr std::array<std::string_view, 6> rate_names = {
    "mocap_framerate", "mocap_frame_rate", "fps", "frame_rate", "framerate", "frames_per_second"};

std::string ask_for_rate() { return std::string("state the rate with ") + rate_option; }

bool is_plausible(double rate) { return rate >= 0.1 && rate <= 10'000.0; }

std::string number(double value) {
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), written.ptr};
}

double rate_in(const NpyArray& array, const std::string& file) {
  const std::vector<double> numbers = numbers_of(array, {file});
  if (numbers.size() == 1 && is_plausible(numbers[0])) return snapped_frame_rate(numbers[0]);
  const std::string value =
      numbers.size() == 1 ? number(numbers[0]) + " Hz" : "of shape " + shape_text(array);
  throw Error({file}, described(array) + " is " + value + ", which is no frame rate",
              ask_for_rate());
}

}  // namespace

std::vector<std::string_view> rate_array_names() { return {rate_names.begin(), rate_names.end()}; }

std::optional<double> stated_rate(const Npz& npz) {
  const NpyArray* first = nullptr;
  double rate = 0.0;
  for (const std::string_view name : rate_names) {
    const NpyArray* const array = find_array(npz, name);
    if (!array) continue;
    const double stated = rate_in(*array, npz.file);
    if (!first) {
      first = array;
      rate = stated;
    } else if (std::abs(stated / rate - 1.0) > 0.001) {
      throw Error({npz.file},
                  "its frame rates contradict each other: " + first->name + " is " + number(rate) +
                      " Hz, " + array->name + " is " + number(stated) + " Hz",
                  ask_for_rate());
    }
  }
  return first ? std::optional(rate) : std::nullopt;
}

double checked_rate(double frames_per_second, const std::string& file_name) {
  if (is_plausible(frames_per_second)) return frames_per_second;
  throw Error(
      {file_name},
      "the given frame rate, " + number(frames_per_second) + ", is not between 0.1 and 10000 Hz",
      "state the rate of the recording");
}

Error no_rate(const std::string& file_name) {
  return Error({file_name}, "does not state its frame rate", ask_for_rate());
}

}  // namespace mien::motion
