#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "motion/error.h"
#include "motion/formats/c3d/c3d.h"
#include "motion/formats/c3d/c3d_bytes.h"
#include "motion/formats/c3d/c3d_layout.h"
#include "motion/formats/c3d/c3d_segments.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/math/geometry.h"
#include "motion/points/point_names.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

constexpr std::size_t values_of_a_segment = 17;
constexpr std::size_t segment_bytes = 4 * values_of_a_segment;

/// Where the matrices lie: frame after frame, 17 floats for each segment.
struct RotationLayout {
  std::size_t segments = 0;
  std::size_t start = 0;
  std::size_t frames = 0;
};

RotationLayout rotation_layout(const C3dFile& file, std::vector<std::string>& notes) {
  RotationLayout layout;
  layout.segments = c3d_count(file, "ROTATION:USED").value_or(0);
  const std::size_t block = c3d_count(file, "ROTATION:DATA_START").value_or(0);
  const std::size_t stated = c3d_count(file, "ROTATION:FRAMES").value_or(0);
  if (layout.segments == 0)
    throw Error({file.name}, "holds no rotations of segments", "read it as points");
  if (block < 2 || (block - 1) * block_bytes >= file.bytes.size()) {
    throw Error({file.name}, "ends before its rotations begin (ROTATION:DATA_START)",
                "obtain the file again, it is cut short");
  }
  layout.start = (block - 1) * block_bytes;
  const std::size_t held = (file.bytes.size() - layout.start) / (layout.segments * segment_bytes);
  if (held == 0) {
    fail_c3d(file, layout.start, "there is no complete frame of rotations",
             "obtain the file again, it is cut short");
  }
  if (stated == 0) {
    notes.push_back("The file does not state its number of rotations: " + std::to_string(held) +
                    " frames, by its size.");
  } else if (stated > held) {
    notes.push_back("ROTATION:FRAMES says " + std::to_string(stated) +
                    " frames, but the file ends after " + std::to_string(held) +
                    ": these are read.");
  }
  layout.frames = stated == 0 ? held : std::min(stated, held);
  require_reasonable_size({file.name}, layout.segments, layout.frames);
  return layout;
}

double rotation_rate(const C3dFile& file, const ReadOptions& options,
                     std::vector<std::string>& notes) {
  const double stated = c3d_number(file, "ROTATION:RATE").value_or(0.0);
  if (std::isfinite(stated) && stated > 1e-3 && stated < 1e6) return stated;
  const double ratio = c3d_number(file, "ROTATION:RATIO").value_or(1.0);
  const std::optional<double> of_points = c3d_stated_rate(file, notes);
  if (!of_points) return c3d_given_rate(file, options);
  return *of_points * (ratio >= 1.0 && ratio < 1e3 ? ratio : 1.0);
}

/// The transform at a byte; nothing if the segment is marked as missing or has no finite matrix.
std::optional<JointTransform> transform_at(const C3dFile& file, std::size_t byte) {
  const char* at = file.bytes.data() + byte;
  const auto value = [&](int row, int column) {
    return static_cast<double>(c3d_real(at + 4 * (4 * column + row), file.processor));
  };
  Mat3 turn;
  Vec3 origin;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) turn(row, column) = value(row, column);
    origin[row] = value(row, 3);
  }
  const float mark = c3d_real(at + 4 * 16, file.processor);
  if (mark < 0.0f || !turn.allFinite() || !origin.allFinite() || turn.isZero()) return std::nullopt;
  constexpr double most_deviation = 0.02;
  if (!(turn.transpose() * turn - Mat3::Identity()).isZero(most_deviation) ||
      turn.determinant() < 0.0 || origin.cwiseAbs().maxCoeff() > 1e12) {
    fail_c3d(file, byte, "a segment's matrix is not a rotation and a position",
             "export the file again");
  }
  return JointTransform{origin, Quat(turn).normalized()};
}

/// All transforms of a segment; missing ones are interpolated or held. Empty if it is never found.
SegmentMotion motion_of(const C3dFile& file, const RotationLayout& layout, std::size_t segment) {
  SegmentMotion motion;
  std::size_t last = layout.frames;  // the last frame with the segment; none yet
  for (std::size_t frame = 0; frame < layout.frames; ++frame) {
    const std::size_t byte = layout.start + (frame * layout.segments + segment) * segment_bytes;
    const std::optional<JointTransform> found = transform_at(file, byte);
    if (!found) {
      ++motion.missing;
      continue;
    }
    if (motion.transforms.empty()) motion.transforms.resize(layout.frames, *found);
    for (std::size_t gap = last == layout.frames ? frame : last + 1; gap < frame; ++gap) {
      const JointTransform& from = motion.transforms[last];
      const double t = static_cast<double>(gap - last) / static_cast<double>(frame - last);
      motion.transforms[gap] = {from.position + t * (found->position - from.position),
                                from.rotation.slerp(t, found->rotation)};
    }
    motion.transforms[frame] = *found;
    last = frame;
  }
  if (motion.transforms.empty()) return motion;
  for (std::size_t frame = last + 1; frame < layout.frames; ++frame)
    motion.transforms[frame] = motion.transforms[last];
  return motion;
}

}  // namespace

bool holds_c3d_rotations(std::string_view bytes) {
  try {
    const C3dFile file = parse_c3d_parameters(bytes, "");
    return c3d_point_count(file) == 0 && c3d_count(file, "ROTATION:USED").value_or(0) > 0;
  } catch (const Error&) {
    return false;
  }
}

Recording parse_c3d_rotations(std::string_view bytes, const std::string& file_name,
                              const ReadOptions& options) {
  const C3dFile file = parse_c3d_parameters(bytes, file_name);
  Recording recording;
  recording.name = recording_name(file_name);
  recording.format = "c3d";
  const RotationLayout layout = rotation_layout(file, recording.notes);
  recording.frames_per_second = rotation_rate(file, options, recording.notes);
  std::vector<std::string> labels = c3d_all_texts(file, "ROTATION:LABELS");
  labels.resize(layout.segments);
  for (std::string& label : labels) label = segment_name(label);
  labels = distinct_point_names(std::move(labels), recording.notes);
  std::vector<SegmentMotion> segments;
  for (std::size_t i = 0; i < layout.segments; ++i) {
    if (is_no_segment(labels[i])) continue;
    segments.push_back(motion_of(file, layout, i));
    segments.back().name = labels[i];
  }
  set_segments(file, std::move(segments), recording);
  return recording;
}

Recording read_c3d_rotations(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "c3d");
  return parse_c3d_rotations(bytes, path.string(), options);
}

}  // namespace mien::motion
