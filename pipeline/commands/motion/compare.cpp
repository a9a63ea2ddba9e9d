#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/examples/compared_example.h"
#include "motion/examples/flight_examples.h"
#include "motion/formats/motion_file.h"
#include "motion/measures/distance/hand_tip_distance.h"
#include "motion/measures/distance/hands_distance.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

struct CompareOptions {
  std::string target;
  std::string created;
  RecordingArguments recording;
  std::string align = "pelvis";
  bool as_captured = false;
  bool hand_tips = false;
  bool json = false;
};

std::string joint_name(std::size_t row) {
  return std::string(motion::name_of(static_cast<motion::BodyJoint>(row + 1)));
}

/// The part of a motion that is compared.
const char* basis_of(const motion::Example& example) {
  return example.clip.loops ? "gait cycle" : "whole duration";
}

/// The two bases, and a warning where they differ.
struct Basis {
  std::string target;
  std::string created;
  std::string target_take;  ///< where its file holds several
  std::string created_take;
  std::string target_person;  ///< where its file holds several
  std::string created_person;

  std::string warning() const {
    if (target == created) return "";
    return "a gait cycle is compared with a motion without one, so the distance means little";
  }
};

constexpr char meaning_of_match[] =
    "match means that D is below the threshold that ends a trial of a published matching task; "
    "this threshold is not a measure of perceptibility";

ordered_json as_json(const motion::Distance& distance, const Basis& basis) {
  ordered_json per_joint = ordered_json::object();
  const auto by_joint = distance.by_joint();
  for (std::size_t j = 0; j < by_joint.size(); ++j) per_joint[joint_name(j)] = by_joint[j];
  return {{"D", distance.mean},
          {"D_sum", distance.sum},
          {"threshold", motion::distance_threshold_m},
          {"match", distance.matches()},
          {"match_means", meaning_of_match},
          {"mpjpe_m", distance.mpjpe},
          {"per_joint", per_joint},
          {"per_time", distance.by_time()},
          {"basis", {{"target", basis.target}, {"created", basis.created}}},
          {"takes", {{"target", basis.target_take}, {"created", basis.created_take}}},
          {"people", {{"target", basis.target_person}, {"created", basis.created_person}}},
          {"warnings", basis.warning().empty() ? ordered_json::array()
                                               : ordered_json::array({basis.warning()})}};
}

/// Shows which motions and people were used of files with several.
void show_choices(const Basis& basis, const Console& console) {
  const auto show = [&](const char* which, const char* what, const std::string& chosen) {
    if (!chosen.empty()) console.out << which << what << chosen << '\n';
  };
  show("target   ", "take ", basis.target_take);
  show("target   ", "person ", basis.target_person);
  show("other    ", "take ", basis.created_take);
  show("other    ", "person ", basis.created_person);
}

void show_text(const motion::Distance& distance, const Basis& basis, const Console& console) {
  console.out << fmt::format(
      "D        {:.4f} m, {} {:.2f} m, the threshold of a published matching task\n", distance.mean,
      distance.matches() ? "below" : "not below", motion::distance_threshold_m);
  console.out << fmt::format("D_sum    {:.3f} m\nMPJPE    {:.1f} mm\n", distance.sum,
                             1000.0 * distance.mpjpe);
  console.out << fmt::format("over     {} of the target, {} of the other motion\n", basis.target,
                             basis.created);
  show_choices(basis, console);
  if (!basis.warning().empty()) console.out << "warning: " << basis.warning() << '\n';
  const auto by_joint = distance.by_joint();
  for (std::size_t j = 0; j < by_joint.size(); ++j)
    console.out << fmt::format("  {:14} {:.4f} m\n", joint_name(j), by_joint[j]);
  const auto by_time = distance.by_time();
  for (std::size_t t = 0; t < by_time.size(); ++t)
    console.out << fmt::format("  at {:3} %       {:.4f} m\n", 10 * t, by_time[t]);
}

int compare(const CompareOptions& options, const Console& console) {
  const auto alignment =
      options.align == "world" ? motion::Alignment::world : motion::Alignment::pelvis;
  const std::vector<NamedRecording> named =
      named_recordings({options.target, options.created}, options.recording);
  const motion::Recording target_file = motion::read_motion(named[0].file, named[0].how);
  const motion::Recording created_file = motion::read_motion(named[1].file, named[1].how);
  motion::Example target = motion::compared_example(target_file, !options.as_captured);
  motion::Example created = motion::compared_example(created_file, !options.as_captured);
  motion::match_keytimes(target, created);
  const motion::Distance distance = motion::distance(target, created, alignment);
  const Basis basis{basis_of(target),           basis_of(created),
                    chosen_take(target_file),   chosen_take(created_file),
                    chosen_person(target_file), chosen_person(created_file)};
  const double with_tips =
      options.hand_tips ? motion::distance_with_hand_tips(target, created, alignment) : 0.0;
  const std::optional<double> hands = motion::hands_distance(target, created);
  if (options.json) {
    ordered_json json = as_json(distance, basis);
    if (options.hand_tips) json["D_with_hand_tips"] = with_tips;
    json["hands_m"] = nullptr;
    if (hands) json["hands_m"] = *hands;
    console.out << json.dump(2) << '\n';
  } else {
    show_text(distance, basis, console);
    if (options.hand_tips)
      console.out << fmt::format("D with the tips of both hands: {:.4f} m\n", with_tips);
    if (hands)
      console.out << fmt::format("hands    {:.4f} m between fingertips, seen from the wrists\n",
                                 *hands);
  }
  return exit_done;
}

}  // namespace

Command motion_compare_command() {
  const auto options = std::make_shared<CompareOptions>();
  return {.name = "compare",
          .summary = "Measure the distance between two motions",
          .options = all_of(
              argument("target", &options->target, "Motion file of the target"),
              argument("created", &options->created, "Motion file to compare with it"),
              options_of_recordings(options->recording),
              option("--align", &options->align,
                     "pelvis: remove horizontal position and heading in every frame; world: in the "
                     "first frame only")
                  .one_of({"pelvis", "world"})
                  .with_default(),
              flag("--as-captured", &options->as_captured,
                   "Do not lock planted feet; by default those of both motions are locked to the "
                   "floor first, as in blends"),
              flag("--hand-tips", &options->hand_tips,
                   "Also give D over 22 points: the joints and the tips of both hands, which "
                   "gestures move more than wrists"),
              flag("--json", &options->json, "As JSON")),
          .notes =
              "Walks are compared over their steadiest gait cycle, keytime by keytime; motions "
              "without a cycle are compared over their whole duration. D is the mean distance of "
              "20 joints at "
              "11 times. Where both have fingers, hands is the mean distance of ten fingertips, "
              "seen from their wrists; it is not part of D. Two motions match if D is below 0.06 "
              "m, the distance that ends a trial "
              "of a published matching task; this threshold is not a measure of "
              "perceptibility.\n\n"
              "Example:\n"
              "  mien motion compare captured.bvh made.bvh --json\n"
              "  mien motion compare dance.c3d dance.c3d --subject Anna --subject Ben\n"
              "  mien motion compare walk.fbx#Slow walk.fbx#Fast",
          .run = [options](const Console& console) { return compare(*options, console); }};
}

}  // namespace mien::pipeline
