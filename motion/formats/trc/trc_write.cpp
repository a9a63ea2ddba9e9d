#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "motion/error.h"
#include "motion/formats/trc/trc.h"

namespace mien::motion {

namespace {

constexpr int millimetre_decimals = 4;
constexpr int metre_decimals = 7;
constexpr int time_decimals = 6;

using Digits = std::array<char, 400>;

/// Fixed notation; zero has no sign.
void append_fixed(std::string& text, double value, int decimals) {
  Digits digits;
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(),
                                                    value, std::chars_format::fixed, decimals);
  std::string_view number(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  if (number.starts_with('-') && number.find_first_of("123456789") == std::string_view::npos)
    number.remove_prefix(1);
  text += number;
}

/// As few digits as give the same number when they are read.
std::string shortest(double value) {
  Digits digits;
  const std::to_chars_result result =
      std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), static_cast<std::size_t>(result.ptr - digits.data())};
}

std::string writable_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '_';
  }
  return name;
}

/// How positions are written: multiplied by `factor`, to so many decimals.
struct Notation {
  double factor = 1.0;
  int decimals = 0;
  std::string unit;
};

Notation notation_of(const PointRecording& recording) {
  if (recording.metres_per_unit == 1.0) return {1.0, metre_decimals, "m"};
  // 1000 times 0.001 is exactly 1.
  return {recording.metres_per_unit * 1000.0, millimetre_decimals, "mm"};
}

void append_position(std::string& text, Vec3 position, const Notation& notation) {
  position *= notation.factor;
  const double smallest = std::pow(10.0, -notation.decimals);
  if (position.cwiseAbs().maxCoeff() <= 0.5 * smallest) position = Vec3(0.0, 0.0, smallest);
  for (int axis = 0; axis < 3; ++axis) {
    text += '\t';
    append_fixed(text, position[axis], notation.decimals);
  }
}

void append_header(std::string& text, const PointRecording& recording, const Notation& notation) {
  const std::string rate = shortest(recording.frames_per_second);
  const std::string frames = std::to_string(recording.frame_count());
  text += "PathFileType\t4\t(X/Y/Z)\t" + writable_name(recording.name) + ".trc\n";
  text +=
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\t"
      "OrigDataStartFrame\tOrigNumFrames\n";
  text += rate + '\t' + rate + '\t' + frames + '\t' + std::to_string(recording.point_count()) +
          '\t' + notation.unit + '\t' + rate + "\t1\t" + frames + '\n';
  text += "Frame#\tTime";
  for (const std::string& name : recording.points) text += '\t' + writable_name(name) + "\t\t";
  text += "\n\t";
  for (int i = 1; i <= recording.point_count(); ++i) {
    for (const char axis : {'X', 'Y', 'Z'}) text.append("\t").append(1, axis) += std::to_string(i);
  }
  text += "\n\n";
}

}  // namespace

std::string to_trc(const PointRecording& recording) {
  if (recording.frame_count() == 0)
    throw Error("a recording without points or frames cannot be written as TRC", "read one");
  if (!(recording.metres_per_unit > 0.0)) {
    throw Error({recording.name}, "the unit of its positions is not known, which TRC must state",
                "state the unit of the recording");
  }
  const Notation notation = notation_of(recording);
  std::string text;
  append_header(text, recording, notation);
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    text += std::to_string(frame + 1) + '\t';
    append_fixed(text, frame / recording.frames_per_second, time_decimals);
    for (int point = 0; point < recording.point_count(); ++point) {
      const std::size_t i = recording.at(frame, point);
      if (recording.seen[i]) {
        append_position(text, recording.positions[i], notation);
      } else {
        text += "\t\t\t";
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace mien::motion
