#include "motion/formats/bvh/bvh_frames.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "motion/formats/bvh/bvh_rotation.h"
#include "motion/formats/reading/frame_rate.h"
#include "motion/formats/reading/option_names.h"

namespace mien::motion {
namespace {

/// Nobody records a motion slower than this; larger numbers are rates.
constexpr double longest_frame_seconds = 2.0;

/// Takes a label such as "Frame Time:", however it is spaced; the colon may be missing.
void expect_label(TextCursor& cursor, std::string_view label) {
  skip_space(cursor);
  const size_t start = cursor.at;
  for (const char c : label) {
    if (c == ' ') {
      skip_blanks(cursor);
    } else if (same_word(cursor.text.substr(cursor.at, 1), {&c, 1})) {
      ++cursor.at;
    } else {
      fail(cursor, start, "expected \"" + std::string(label) + ":\"",
           at_end(cursor) ? "the file is truncated: obtain it again"
                          : "MOTION is followed by Frames: and Frame Time:");
    }
  }
  skip_blanks(cursor);
  if (!at_end(cursor) && cursor.text[cursor.at] == ':') ++cursor.at;
}

void expect_line_end(TextCursor& cursor) {
  skip_blanks(cursor);
  if (at_line_end(cursor)) return;
  fail(cursor, cursor.at, "nothing more is expected on this line", "start a new line here");
}

/// What was meant where a frame time is a rate: "0.00833333 for 120 frames per second".
std::string frame_time_of(double written) {
  const double rate = written > longest_frame_seconds && written <= 1000.0 ? written : 30.0;
  char text[64];
  std::snprintf(text, sizeof text, "%.6g for %g frames per second", 1.0 / rate, rate);
  return text;
}

bool moves_other_joints(const BvhHierarchy& hierarchy) {
  return std::any_of(hierarchy.channels.begin(), hierarchy.channels.end(),
                     [](const BvhChannel& c) { return !c.rotation && c.joint > 0; });
}

/// Where a line ended before its frame did: the frame may go on in the next, or lack numbers.
struct ShortLine {
  size_t place = 0;
  size_t taken = 0;
};

[[noreturn]] void refuse_short_frame(const TextCursor& cursor, const ShortLine& line,
                                     size_t channels) {
  fail(cursor, line.place,
       "this frame ends after " + std::to_string(line.taken) + " of " + std::to_string(channels) +
           " numbers",
       at_end(cursor) ? "the file is truncated: obtain it again"
                      : "give each frame a number for every channel");
}

void set_channel(Pose& pose, const BvhChannel& channel, double value) {
  if (channel.joint < 0) return;
  const auto joint = static_cast<size_t>(channel.joint);
  if (channel.rotation) {
    pose.rotations[joint] = turned(pose.rotations[joint], channel.axis, value);
  } else if (joint == 0) {
    pose.root_position[static_cast<int>(channel.axis)] = value;
  } else {
    pose.offsets[joint][static_cast<int>(channel.axis)] = value;
  }
}

}  // namespace

BvhFrameCount parse_bvh_frame_count(TextCursor& cursor) {
  expect_label(cursor, "Frames");
  skip_space(cursor);
  const size_t place = cursor.at;
  const auto count = static_cast<size_t>(parse_count(cursor, "the number of frames"));
  expect_line_end(cursor);
  return {count, place};
}

double parse_bvh_frame_rate(TextCursor& cursor, std::optional<double> given) {
  skip_space(cursor);
  const bool has_line = same_word(cursor.text.substr(cursor.at, 1), "F");
  if (given && !has_line) return *given;
  expect_label(cursor, "Frame Time");
  skip_space(cursor);
  const size_t place = cursor.at;
  const double seconds = parse_number(cursor, "seconds per frame");
  const bool is_frame_time = seconds >= 1e-5 && seconds <= longest_frame_seconds;
  if (!is_frame_time && !given) {
    const std::string written(in_quotes(cursor.text.substr(place, cursor.at - place)));
    fail(cursor, place, "a frame time of " + written + " seconds",
         "give the seconds between two frames, not the number of frames per second: " +
             frame_time_of(seconds) + "; or state the rate with " + rate_option);
  }
  const size_t end = cursor.at;
  expect_line_end(cursor);
  if (!is_frame_time) return *given;
  return frame_rate_of_period(seconds, cursor.text.substr(place, end - place));
}

Pose bvh_pose_before_channels(const BvhHierarchy& hierarchy) {
  const std::vector<Joint>& joints = hierarchy.skeleton.joints;
  Pose pose;
  pose.root_position = joints.front().offset;
  pose.rotations.assign(joints.size(), Quat::Identity());
  if (moves_other_joints(hierarchy)) {
    for (const Joint& joint : joints) pose.offsets.push_back(joint.offset);
  }
  return pose;
}

void parse_bvh_frame(TextCursor& cursor, const BvhHierarchy& hierarchy, Pose& pose) {
  const size_t channels = hierarchy.channels.size();
  std::optional<ShortLine> wrapped;
  for (size_t taken = 0; taken < channels; ++taken) {
    skip_blanks(cursor);
    if (at_line_end(cursor)) {
      if (!wrapped) wrapped = ShortLine{cursor.at, taken};
      skip_space(cursor);
      if (at_end(cursor)) refuse_short_frame(cursor, *wrapped, channels);
    }
    set_channel(pose, hierarchy.channels[taken], parse_number(cursor, "one per channel"));
  }
  skip_blanks(cursor);
  if (!at_line_end(cursor)) {
    if (wrapped) refuse_short_frame(cursor, *wrapped, channels);
    fail(cursor, cursor.at, "this frame has more than " + std::to_string(channels) + " numbers",
         "give each frame a number for every channel, and begin the next on a new line");
  }
  for (Quat& rotation : pose.rotations) rotation.normalize();
}

}  // namespace mien::motion
