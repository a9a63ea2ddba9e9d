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

std::string ask_for_rate() {
  std::string remedy = "state the rate with ";
  remedy += rate_option;
  return remedy;
}

bool is_plausible(double rate) { return rate >= 0.1 && rate <= 10'000.0; }

std::string number(double value) {
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), written.ptr};
}

/// What the arrays of a file state, and what is wrong with it.
struct StatedRate {
  std::optional<double> rate;
  std::string fault;  ///< "its frame rates contradict each other: …"; empty: none
};

StatedRate rate_in(const NpyArray& array, const std::string& file) {
  const std::vector<double> numbers = numbers_of(array, {file});
  if (numbers.size() == 1 && is_plausible(numbers[0])) return {snapped_frame_rate(numbers[0]), {}};
  const std::string value =
      numbers.size() == 1 ? number(numbers[0]) + " Hz" : "of shape " + shape_text(array);
  return {{}, described(array) + " is " + value + ", which is no frame rate"};
}

StatedRate stated_rate(const Npz& npz) {
  const NpyArray* first = nullptr;
  double rate = 0.0;
  for (const std::string_view name : rate_names) {
    const NpyArray* const array = find_array(npz, name);
    if (!array) continue;
    const StatedRate stated = rate_in(*array, npz.file);
    if (!stated.rate) return stated;
    if (!first) {
      first = array;
      rate = *stated.rate;
    } else if (std::abs(*stated.rate / rate - 1.0) > 0.001) {
      return {{},
              "its frame rates contradict each other: " + first->name + " is " + number(rate) +
                  " Hz, " + array->name + " is " + number(*stated.rate) + " Hz"};
    }
  }
  return {first ? std::optional(rate) : std::nullopt, {}};
}

/// Throws mien::Error if a rate that the user gave is not between 0.1 and 10,000.
double checked_rate(double frames_per_second, const std::string& file_name) {
  if (is_plausible(frames_per_second)) return frames_per_second;
  throw Error(
      {file_name},
      "the given frame rate, " + number(frames_per_second) + ", is not between 0.1 and 10000 Hz",
      "state the rate of the recording");
}

}  // namespace

std::vector<std::string_view> rate_array_names() { return {rate_names.begin(), rate_names.end()}; }

std::optional<double> rate_of_arrays(const Npz& npz, const ReadOptions& options) {
  const StatedRate stated = stated_rate(npz);
  if (stated.rate) return stated.rate;
  if (options.frames_per_second) return checked_rate(*options.frames_per_second, npz.file);
  if (!stated.fault.empty()) throw Error({npz.file}, stated.fault, ask_for_rate());
  return std::nullopt;
}

Error no_rate(const std::string& file_name) {
  return Error({file_name}, "does not state its frame rate", ask_for_rate());
}

}  // namespace mien::motion
