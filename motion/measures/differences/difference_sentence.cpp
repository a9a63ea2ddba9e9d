#include "motion/measures/differences/difference_sentence.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace mien::motion {

namespace {

constexpr double least_reported_slide_m = 0.001;
constexpr double least_reported_offset_m = 0.01;
constexpr double rounding_m = 1e-5;
constexpr double rounding_radians = 1e-4;

std::string formatted(const char* form, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), form, value);
  return text.data();
}

/// With a digit after the point from 1 on, else with two digits that say something, down to 0.001.
std::string digits(double value) {
  const double size = std::abs(value);
  if (size > 0.0 && size < 0.001) return "under 0.001";
  return formatted(size >= 1.0 ? "%.1f" : "%.2g", value);
}

std::string frame_count_text(int frames) {
  return std::to_string(frames) + (frames == 1 ? " frame" : " frames");
}

std::string describe_shift(const TimeShift& shift) {
  const int frames = std::abs(shift.frames);
  return std::string(shift.path_too ? "the motion comes " : "the poses come ") +
         frame_count_text(frames) + " (" + in_seconds(std::abs(shift.seconds)) + ") " +
         (shift.frames > 0 ? "later" : "earlier");
}

std::string describe_gap(const FrameGap& gap, double rate) {
  const int frames = std::abs(gap.frames);
  return frame_count_text(frames) + (frames == 1 ? " was " : " were ") +
         (gap.frames < 0 ? "excluded" : "put in") + " at " + in_seconds(gap.frame / rate);
}

std::string describe_pace(const TimingDifference& timing) {
  return "the same frames, played at " + formatted("%.4g", timing.now.frames_per_second) +
         " instead of " + formatted("%.4g", timing.before.frames_per_second) + " per second";
}

std::string ordinal(int number) {
  if (number == 2) return "second";
  return number == 3 ? "third" : std::to_string(number) + "th";
}

std::string describe_whole(const WholeBodyChange& whole) {
  switch (whole.kind) {
    case WholeChange::mirrored:
      return "the motion is mirrored: left and right are swapped";
    case WholeChange::flipped:
      return "the motion is mirrored, but joint names are unchanged";
    case WholeChange::renamed_sides:
      return "the names of left and right joints are swapped; the motion is unchanged";
    case WholeChange::swapped_turns:
      return "the rotations of left and right joints are swapped";
    case WholeChange::scaled:
      return "all lengths are " + formatted("%.4g", whole.scale) +
             " times as long, as with another unit; otherwise the motion is the same";
    case WholeChange::moved:
    case WholeChange::none:
      break;
  }
  return "";
}

bool is_of_all(WholeChange kind) { return kind != WholeChange::none && kind != WholeChange::moved; }

std::string at_time(double seconds) { return ", at " + in_seconds(seconds); }

std::string at(const MotionDifference& difference, int frame) {
  return at_time(frame / difference.frames_per_second());
}

/// Describes the change of the root of a figure whose poses are equal.
std::string describe_root(const MotionDifference& difference) {
  const RootDifference& root = difference.root;
  const CurvePeak path = peak_of(root.path_m);
  const CurvePeak height = peak_of(root.height_m);
  const CurvePeak heading = peak_of(root.heading_radians);
  const CurvePeak tilt = peak_of(root.tilt_radians);
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  if (path.value > rounding_m) add("is displaced by up to " + in_centimetres(path.value));
  if (height.value > rounding_m)
    add("is up to " + in_centimetres(height.value) + " higher or lower");
  if (heading.value > rounding_radians)
    add("heads up to " + in_degrees(heading.value) + " in another direction");
  if (tilt.value > rounding_radians)
    add("leans up to " + in_degrees(tilt.value) + " in another direction");
  return text.empty() ? "" : "the figure " + text + "; its poses are unchanged";
}

std::string describe_turn(const MotionDifference& difference, const JointDifference& joint) {
  const CurvePeak turn = peak_of(joint.turn_radians);
  const double twist = joint.twist_radians[turn.frame];
  const char* verb = " turned";
  if (twist >= 0.9 * turn.value) verb = " twisted";
  if (twist <= 0.3 * turn.value) verb = " bent";
  return joint.part + verb + " by up to " + in_degrees(turn.value) + at(difference, turn.frame);
}

/// Joints that carry the whole body are placed in the world, whatever they hang on in the file.
std::string describe_bone(const MotionDifference& difference) {
  const JointDifference* worst = nullptr;
  CurvePeak most;
  for (std::size_t j = 0; j < difference.joints.size(); ++j) {
    const CurvePeak peak = peak_of(difference.joints[j].offset_m);
    if (peak.value <= most.value || carries_body(difference, static_cast<int>(j))) continue;
    worst = &difference.joints[j];
    most = peak;
  }
  if (most.value <= rounding_m) return "";
  return "the joint of " + worst->part + " sits up to " + in_centimetres(most.value) +
         " elsewhere on the body";
}

/// Where the figure stands, of one whose poses differ too.
std::string describe_place(const MotionDifference& difference) {
  const CurvePeak path = peak_of(difference.root.path_m);
  return path.value < least_reported_offset_m
             ? ""
             : "the figure is displaced by up to " + in_centimetres(path.value);
}

std::string describe_order(const TimingDifference& timing) {
  const std::string rates = formatted("%.4g", timing.now.frames_per_second) + " instead of " +
                            formatted("%.4g", timing.before.frames_per_second) + " per second";
  if (timing.reversed) return "the same frames in reverse order";
  if (timing.every > 1) return "only every " + ordinal(timing.every) + " frame, " + rates;
  return "each frame of before is every " + ordinal(-timing.every) + " one now, " + rates;
}

std::string describe_slide(const MotionDifference& difference) {
  if (!difference.body) return "";
  const auto& feet = difference.body->feet;
  const bool left = feet[0].slide_m >= feet[1].slide_m;
  const FootDifference& foot = feet[left ? 0 : 1];
  if (foot.slide_m < least_reported_slide_m) return "";
  return std::string(left ? "left" : "right") + " foot slides up to " +
         in_centimetres(foot.slide_m) + " while planted" + at_time(foot.slide_seconds);
}

/// Describes changes of parts of the body.
std::string describe_parts(const MotionDifference& difference) {
  std::string text = describe_bone(difference);
  std::vector<int> joints = causes(difference);
  std::erase_if(joints, [&](int joint) {  // reported by the figure's position
    return carries_body(difference, joint) &&
           peak_of(difference.joints[joint].turn_radians).value <= rounding_radians;
  });
  if (text.empty() && !joints.empty())
    text = describe_turn(difference, difference.joints[joints.front()]);
  if (joints.size() > 1)
    text += " (and " + std::to_string(joints.size() - 1) +
            (joints.size() == 2 ? " other joint)" : " other joints)");
  for (const std::string& more : {describe_place(difference), describe_slide(difference)}) {
    if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
  }
  return text;
}

std::string describe_names(const MotionDifference& difference) {
  const auto& [was, is] = difference.renamed.front();
  const std::size_t count = difference.renamed.size();
  return std::to_string(count) + (count == 1 ? " joint is" : " joints are") + " renamed (" + was +
         " is " + is + " now); the motion is the same";
}

std::string describe_rest(const MotionDifference& difference) {
  const TimingDifference& timing = difference.timing;
  if (timing.before.frames != timing.now.frames)
    return frame_count_text(timing.now.frames) + " instead of " +
           std::to_string(timing.before.frames);
  if (!timing.same_length()) return "another frame rate";
  const WorstJoint moved = worst_joint(difference, &JointDifference::point_m);
  if (moved.peak.value > rounding_m)
    return difference.joints[moved.joint].part + " differs by up to " +
           in_centimetres(moved.peak.value) + at(difference, moved.peak.frame);
  if (!difference.renamed.empty()) return describe_names(difference);
  if (!difference.only_before.empty() || !difference.only_now.empty()) return "other joints";
  return difference.identical ? "no difference" : "no more than rounding";
}

}  // namespace

std::string in_degrees(double radians) { return digits(radians / radians_per_degree) + "°"; }

std::string in_centimetres(double metres) { return digits(100.0 * metres) + " cm"; }

std::string in_seconds(double seconds) { return formatted("%.2f s", seconds); }

std::string largest_change(const MotionDifference& difference) {
  const TimingDifference& timing = difference.timing;
  if (timing.other_pace) return describe_pace(timing);
  if (timing.reversed || timing.every != 1) return describe_order(timing);
  if (timing.shift) return describe_shift(*timing.shift);
  if (timing.gap) return describe_gap(*timing.gap, difference.frames_per_second());
  if (is_of_all(difference.whole.kind)) return describe_whole(difference.whole);
  std::string text =
      is_root_only(difference) ? describe_root(difference) : describe_parts(difference);
  return text.empty() ? describe_rest(difference) : text;
}

}  // namespace mien::motion
