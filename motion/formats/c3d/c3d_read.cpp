#include <optional>
#include <string>

#include "motion/error.h"
#include "motion/formats/c3d/c3d.h"
#include "motion/formats/c3d/c3d_columns.h"
#include "motion/formats/c3d/c3d_layout.h"
#include "motion/formats/c3d/c3d_points.h"
#include "motion/points/length_unit.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

void read_unit(const C3dFile& file, PointRecording& recording) {
  const std::vector<std::string> units = c3d_texts(file, "POINT:UNITS");
  if (!units.empty()) recording.unit = units.front();
  recording.metres_per_unit = metres_in_unit(recording.unit);
  if (recording.metres_per_unit > 0.0) return;
  recording.notes.push_back(recording.unit.empty()
                                ? "The file does not state the unit of its positions."
                                : "The unit of the positions, " + in_quotes(recording.unit) +
                                      ", is not known.");
}

/// "+Z" of "+Z", "Z" or "z "; nothing of other texts.
std::optional<std::string> axis_in(const std::string& text) {
  const std::size_t sign = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  if (text.size() != sign + 1) return std::nullopt;
  const char letter = static_cast<char>(text[sign] & ~0x20);
  if (letter < 'X' || letter > 'Z') return std::nullopt;
  return std::string(text.starts_with('-') ? "-" : "+") + letter;
}

/// The axis that is up on the screens of laboratories, Y_SCREEN, unless it is also the one that
/// points right there, X_SCREEN.
void read_up(const C3dFile& file, PointRecording& recording) {
  const auto stated = [&](const char* parameter) {
    const std::vector<std::string> texts = c3d_texts(file, parameter);
    return texts.empty() ? std::string() : texts.front();
  };
  const std::string right = stated("POINT:X_SCREEN");
  const std::string up = stated("POINT:Y_SCREEN");
  if (up.empty()) return;
  const std::optional<std::string> axis = axis_in(up);
  const std::optional<std::string> other = axis_in(right);
  if (axis && !(other && other->back() == axis->back())) {
    recording.stated_up = *axis;
  } else {
    recording.notes.push_back("The axes of the screen, POINT:X_SCREEN " + in_quotes(right) +
                              " and POINT:Y_SCREEN " + in_quotes(up) +
                              ", are not two axes, so they do not tell which way is up.");
  }
}

}  // namespace

PointRecording parse_c3d(std::string_view bytes, const std::string& file_name,
                         const ReadOptions& options) {
  const C3dFile file = parse_c3d_parameters(bytes, file_name);
  const std::size_t rotations = c3d_count(file, "ROTATION:USED").value_or(0);
  if (c3d_point_count(file) == 0) {
    throw Error(
        {file_name},
        rotations > 0 ? "holds rotations of segments and no points" : "holds no points",
        rotations > 0 ? "read it as a motion of a skeleton" : "export it again with its markers");
  }
  PointRecording recording;
  recording.name = recording_name(file_name);
  recording.format = "c3d";
  const C3dLayout layout = c3d_layout(file, options, recording.notes);
  C3dColumns columns = c3d_columns(file, layout.points, options, recording.notes);
  recording.frames_per_second = layout.frames_per_second;
  read_unit(file, recording);
  read_up(file, recording);
  read_c3d_points(file, layout, columns.columns, recording);
  recording.points = std::move(columns.names);
  recording.subjects = std::move(columns.subjects);
  recording.subject = std::move(columns.subject);
  recording.events = c3d_events(file, layout, options.subject ? recording.subject : std::string());
  if (rotations > 0) {
    recording.notes.push_back("The rotations of " + std::to_string(rotations) +
                              " segments, which the file holds as well, are not read.");
  }
  return recording;
}

PointRecording read_c3d(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "c3d");
  return parse_c3d(bytes, path.string(), options);
}

}  // namespace mien::motion
