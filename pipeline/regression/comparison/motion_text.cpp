#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/measures/differences/difference_sentence.h"
#include "pipeline/regression/comparison/compared_motions.h"
#include "pipeline/regression/comparison/distinct_numbers.h"

namespace mien::pipeline {

namespace {

using motion::in_centimetres;
using motion::in_degrees;
using motion::in_seconds;
using motion::JointDifference;
using motion::MotionDifference;

constexpr std::size_t most_joints_listed = 8;

std::string motion_length_text(const motion::MotionLength& length, const std::string& rate,
                               const std::string& seconds) {
  return fmt::format("{} {} at {} per second, {} s{}", length.frames,
                     length.frames == 1 ? "frame" : "frames", rate, seconds,
                     length.loops ? ", a loop" : "");
}

/// The left column, its words, and a mark where it is too much.
class Lines {
 public:
  explicit Lines(const ComparedMotions& motions) : motions_(motions) {}

  /// A line about the measures of these names, of which there may be none.
  void add(const std::vector<std::string>& measures, const std::string& words,
           const std::string& told) {
    const bool too_much = std::ranges::any_of(motions_.excesses, [&](const motion::Excess& excess) {
      return std::ranges::find(measures, excess.measure) != measures.end();
    });
    text_ += fmt::format("{} {:<10} {}\n", too_much ? "✗" : " ", words, told);
  }
  std::string text() const { return text_; }

 private:
  const ComparedMotions& motions_;
  std::string text_;
};

/// "up to 0.25 cm (left hand, at 0.43 s), RMS 0.1 cm"
std::string curve_text(const MotionDifference& difference,
                       std::vector<double> JointDifference::*curve, std::string (*amount)(double)) {
  const motion::WorstJoint worst = worst_joint(difference, curve);
  if (worst.peak.value == 0.0) return "the same";
  return fmt::format("up to {} ({}, at {}), RMS {}", amount(worst.peak.value),
                     difference.joints[static_cast<std::size_t>(worst.joint)].part,
                     in_seconds(worst.peak.frame / difference.frames_per_second()),
                     amount(root_mean_square(difference, curve)));
}

std::string in_centimetres_a_second(double metres_a_second) {
  return in_centimetres(metres_a_second) + "/s";
}

void add_timing(Lines& lines, const MotionDifference& difference) {
  const motion::MotionLength &was = difference.timing.before, &is = difference.timing.now;
  const auto rates = distinct_numbers(was.frames_per_second, is.frames_per_second, 4);
  const auto seconds = distinct_numbers(was.seconds, is.seconds, 4);
  const std::string before = motion_length_text(was, rates.first, seconds.first);
  const std::string now = motion_length_text(is, rates.second, seconds.second);
  lines.add({"duration", "frame-rate", "loop"}, "timing",
            before == now ? before + ", the same" : now + "; was " + before);
}

std::string joint_errors_text(const MotionDifference& difference) {
  std::string text = fmt::format("{} in the world, {} from the root, {} after aligning each pose",
                                 in_centimetres(difference.errors.mpjpe),
                                 in_centimetres(difference.errors.root_relative_mpjpe),
                                 in_centimetres(difference.errors.pa_mpjpe));
  if (difference.body) text += fmt::format("; D {:.4f} m", difference.body->d_m);
  return text;
}

void add_root(Lines& lines, const MotionDifference& difference) {
  const motion::RootDifference& root = difference.root;
  const double path = motion::peak_of(root.path_m).value;
  const double height = motion::peak_of(root.height_m).value;
  const double heading = motion::peak_of(root.heading_radians).value;
  const double tilt = motion::peak_of(root.tilt_radians).value;
  const bool same = path + height + heading + tilt == 0.0;
  lines.add(
      {}, "path",
      same ? "the same"
           : fmt::format("position up to {}, height {}, heading {}, lean {}", in_centimetres(path),
                         in_centimetres(height), in_degrees(heading), in_degrees(tilt)));
}

std::string contact_change_text(const motion::ContactChange& change) {
  const std::string when = fmt::format("{:.2f}–{:.2f} s", change.begin_seconds, change.end_seconds);
  switch (change.kind) {
    case motion::ContactChange::Kind::gone:
      return "is no longer planted at " + when;
    case motion::ContactChange::Kind::appeared:
      return "is planted at " + when + " (was not)";
    case motion::ContactChange::Kind::shifted:
      break;
  }
  return fmt::format("planted at {}: starts {:+.3f} s, ends {:+.3f} s", when, change.begin_shift,
                     change.end_shift);
}

void add_contacts(Lines& lines, const motion::BodyDifference& body) {
  bool same = true;
  for (std::size_t side = 0; side < 2; ++side) {
    const motion::FootDifference& foot = body.feet[side];
    const std::string name = side == 0 ? "left foot" : "right foot";
    for (const motion::ContactChange& change : foot.changes)
      lines.add({"contacts"}, "contacts", name + " " + contact_change_text(change));
    if (foot.slide_m > 1e-4)
      lines.add({"slide"}, "slide",
                fmt::format("{} slides up to {} while planted, at {}", name,
                            in_centimetres(foot.slide_m), in_seconds(foot.slide_seconds)));
    same = same && foot.changes.empty();
  }
  if (same) lines.add({"contacts"}, "contacts", "the same");
}

void add_lint(Lines& lines, const MotionDifference& difference) {
  for (const motion::LintChange& change : difference.lint)
    lines.add({"lint"}, "lint",
              fmt::format("{} {}: {}", name_of(change.kind), name_of(change.finding.severity),
                          change.finding.sentence));
  if (difference.lint.empty()) lines.add({"lint"}, "lint", "none appeared, none disappeared");
}

void add_features(Lines& lines, const MotionDifference& difference) {
  for (const motion::FeatureDifference& change : difference.features) {
    if (!change.is_notable()) continue;
    const motion::MotionFeature& feature =
        motion::motion_features()[static_cast<std::size_t>(change.feature)];
    const auto shown = [&](double value) {
      return std::isfinite(value) ? fmt::format("{:.2f}", value) : std::string("none");
    };
    lines.add({}, "feature",
              fmt::format("{}: {} {}, was {}", feature.name, shown(change.now),
                          motion::symbol_of(feature.unit), shown(change.before)));
  }
}

std::string joint_text(const JointDifference& joint, bool is_on_bone) {
  const motion::CurvePeak turn = motion::peak_of(joint.turn_radians);
  const double bone = motion::peak_of(joint.offset_m).value;
  std::string text =
      fmt::format("rotated {}, of which twist {}; displaced {}", in_degrees(turn.value),
                  in_degrees(motion::peak_of(joint.twist_radians).value),
                  in_centimetres(motion::peak_of(joint.point_m).value));
  if (is_on_bone && bone > 1e-5)
    text += fmt::format("; offset on its bone {}", in_centimetres(bone));
  return text;
}

/// "left forearm (LeftElbow)"
std::string joint_name(const JointDifference& joint) {
  return joint.part == joint.name ? joint.name : fmt::format("{} ({})", joint.part, joint.name);
}

void add_causes(Lines& lines, const MotionDifference& difference) {
  const std::vector<int> joints = causes(difference);
  for (std::size_t i = 0; i < std::min(joints.size(), most_joints_listed); ++i) {
    const JointDifference& joint = difference.joints[static_cast<std::size_t>(joints[i])];
    const bool is_on_bone = !carries_body(difference, joints[i]);
    lines.add({}, "joint",
              fmt::format("{:<30} {}", joint_name(joint), joint_text(joint, is_on_bone)));
  }
  if (joints.size() > most_joints_listed)
    lines.add({}, "", fmt::format("and {} more (--json)", joints.size() - most_joints_listed));
  if (!difference.renamed.empty()) {
    std::vector<std::string> names;
    for (const auto& [was, is] : difference.renamed) names.push_back(was + " → " + is);
    lines.add({"joints"}, "names", fmt::format("{}", fmt::join(names, ", ")));
  }
  if (!difference.only_before.empty())
    lines.add({"joints"}, "joints",
              fmt::format("gone: {}", fmt::join(difference.only_before, ", ")));
  if (!difference.only_now.empty())
    lines.add({"joints"}, "joints", fmt::format("new: {}", fmt::join(difference.only_now, ", ")));
}

/// What differs most; where another frame rate is no difference, beside that.
std::string headline(const ComparedMotions& motions) {
  MotionDifference difference = motions.difference;
  motion::TimingDifference& timing = difference.timing;
  const double rate = timing.before.frames_per_second;
  if (!motions.tolerance.any_rate || motion::same_rate(rate, timing.now.frames_per_second))
    return motion::largest_change(difference);
  timing.now.frames_per_second = rate;
  timing.now.frames = timing.before.frames;
  timing.every = 1;
  std::string text = motion::largest_change(difference);
  if (motions.are_alike() || motions.excesses.empty()) return text;
  std::vector<std::string> measures;
  for (const motion::Excess& excess : motions.excesses) measures.push_back(excess.measure);
  return fmt::format("{}; beyond the limits: {}", text, fmt::join(measures, ", "));
}

/// Which motions were taken of files that hold several.
std::string take_names_text(const ComparedMotions& motions) {
  std::string text;
  if (!motions.take_before.empty())
    text += fmt::format("  take before: {} of {}\n", motions.take_before, motions.before);
  if (!motions.take_now.empty())
    text += fmt::format("  take now: {} of {}\n", motions.take_now, motions.now);
  if (!motions.person_before.empty())
    text += fmt::format("  person before: {} of {}\n", motions.person_before, motions.before);
  if (!motions.person_now.empty())
    text += fmt::format("  person now: {} of {}\n", motions.person_now, motions.now);
  return text;
}

std::string verdict(const ComparedMotions& motions) {
  if (motions.difference.identical) return "identical";
  return motions.are_alike() ? "alike" : "differs";
}

}  // namespace

std::string as_text(const ComparedMotions& motions) {
  const MotionDifference& difference = motions.difference;
  const std::string head =
      fmt::format("{}: {} ({})\n", motions.now, verdict(motions), headline(motions)) +
      take_names_text(motions);
  if (difference.identical) return head;
  if (difference.whole.kind == motion::WholeChange::scaled) {  // all else follows from that
    std::string text = head;
    for (const std::string& remark : difference.remarks) text += "  " + remark + "\n";
    return text;
  }
  Lines lines(motions);
  add_timing(lines, difference);
  lines.add({"position"}, "position",
            curve_text(difference, &JointDifference::point_m, in_centimetres));
  lines.add({"rotation"}, "rotation",
            curve_text(difference, &JointDifference::turn_radians, in_degrees));
  lines.add({"velocity"}, "velocity",
            curve_text(difference, &JointDifference::velocity_m_s, in_centimetres_a_second));
  lines.add({}, "mean", joint_errors_text(difference));
  add_root(lines, difference);
  add_causes(lines, difference);
  if (difference.body) add_contacts(lines, *difference.body);
  add_lint(lines, difference);
  add_features(lines, difference);
  std::string text = head + lines.text();
  if (difference.on_body) text += "  The rigs differ; both were retargeted to one body first.\n";
  for (const std::string& remark : difference.remarks) text += "  " + remark + "\n";
  return text;
}

}  // namespace mien::pipeline
