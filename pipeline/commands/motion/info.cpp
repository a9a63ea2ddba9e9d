#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/fitting/recorded_points.h"
#include "motion/formats/motion_file.h"
#include "motion/formats/stated_unit.h"
#include "motion/measures/features/motion_summary.h"
#include "motion/points/gaps.h"
#include "motion/points/marker_sets.h"
#include "motion/points/point_axes.h"
#include "motion/rig/recording_clip.h"
#include "motion/text/excerpt.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"
#include "pipeline/commands/motion/shown_drives.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

struct InfoOptions {
  std::string file;
  RecordingArguments recording;
  bool json = false;
};

/// Rounds seconds or metres to 0.0001, which is finer than the accuracy of any capture.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

ordered_json as_json(const motion::GaitCycle& cycle) {
  ordered_json keytimes = ordered_json::array();
  for (const double seconds : cycle.keytimes) keytimes.push_back(rounded(seconds));
  return {{"start_frame", cycle.start_frame},
          {"end_frame", cycle.end_frame},
          {"keytimes_s", keytimes},
          {"speed_m_s", rounded(cycle.speed_m_s)},
          {"steadiness", rounded(cycle.steadiness)}};
}

ordered_json as_json(const motion::JointSummary& joint) {
  return {{"joint", joint.joint},
          {"from", joint.rig_joints},
          {"found_by", joint.found_by},
          {"confidence", rounded(joint.confidence)}};
}

ordered_json as_json(const motion::HandSummary& hand) {
  ordered_json joints = ordered_json::array();
  for (const motion::FingerJointSummary& joint : hand.joints)
    joints.push_back({{"joint", joint.joint}, {"from", joint.rig_joint}});
  return {{"hand", hand.is_left ? "left" : "right"},
          {"recorded", hand.is_recorded},
          {"joints", joints},
          {"missing", hand.missing}};
}

ordered_json as_json(const motion::MotionSummary& summary) {
  ordered_json mapping = ordered_json::array();
  for (const motion::JointSummary& joint : summary.joints) mapping.push_back(as_json(joint));
  ordered_json cycles = ordered_json::array();
  for (const motion::GaitCycle& cycle : summary.cycles) cycles.push_back(as_json(cycle));
  ordered_json result = {{"frames", summary.frames},
                         {"fps", rounded(summary.frames_per_second)},
                         {"duration_s", rounded(summary.duration_seconds)},
                         {"joints", summary.joint_names},
                         {"rig", summary.rig},
                         {"human", summary.is_human},
                         {"confidence", rounded(summary.confidence)},
                         {"height_m", rounded(summary.height_m)},
                         {"unit_m", summary.unit_m},
                         {"up", summary.up},
                         {"speed_m_s", rounded(summary.speed_m_s)},
                         {"cycles", cycles}};
  result["steadiest_cycle"] = nullptr;
  if (summary.steadiest >= 0) result["steadiest_cycle"] = summary.steadiest;
  if (!summary.takes.empty()) {
    result["takes"] = summary.takes;
    result["take"] = summary.take;
  }
  result["mapping"] = mapping;
  result["hands"] = ordered_json::array();
  for (const motion::HandSummary& hand : summary.hands) result["hands"].push_back(as_json(hand));
  result["warnings"] = summary.warnings;
  return result;
}

void show_mapping(const motion::MotionSummary& summary, const Console& console) {
  for (const motion::JointSummary& joint : summary.joints)
    console.out << fmt::format("  {:14} {:28} {:10} {:3.0f} %\n", joint.joint,
                               fmt::format("{}", fmt::join(joint.rig_joints, " + ")),
                               joint.found_by, 100.0 * joint.confidence);
}

/// "hands    left (15 finger joints) and right (12 finger joints)"
void show_hands(const motion::MotionSummary& summary, const Console& console) {
  if (summary.hands.empty()) return;
  std::vector<std::string> hands;
  for (const motion::HandSummary& hand : summary.hands)
    hands.push_back(
        fmt::format("{} ({} finger joints)", hand.is_left ? "left" : "right", hand.joints.size()));
  console.out << fmt::format("hands    {}{}\n", fmt::join(hands, " and "),
                             summary.hands.front().is_recorded
                                 ? ""
                                 : "; the fingers never leave their rest: nothing was recorded");
}

void show_cycles(const motion::MotionSummary& summary, const Console& console) {
  if (summary.cycles.empty()) {
    console.out << "gait     no complete cycle\n";
    return;
  }
  console.out << fmt::format("gait     {} cycles\n", summary.cycles.size());
  for (std::size_t i = 0; i < summary.cycles.size(); ++i) {
    const motion::GaitCycle& cycle = summary.cycles[i];
    const bool is_steadiest = static_cast<int>(i) == summary.steadiest;
    console.out << fmt::format("  frames {:5} to {:5}  {:.2f} s  {:.2f} m/s  steadiness {:.2f}{}\n",
                               cycle.start_frame, cycle.end_frame, cycle.keytimes.back(),
                               cycle.speed_m_s, cycle.steadiness,
                               is_steadiest ? "  (used when the file is an example)" : "");
  }
}

/// "5 cm"
std::string length_in_words(double metres) {
  if (metres < 0.01) return fmt::format("{:.6g} mm", metres * 1000.0);
  if (metres < 1.0) return fmt::format("{:.6g} cm", metres * 100.0);
  return fmt::format("{:.6g} m", metres);
}

/// "1 m"; of a file whose motion is converted on reading, "2.54 cm (stated by the file), converted
/// to m". `metres`: of a unit of the motion as read.
std::string unit_in_words(double metres, std::optional<double> stated, std::string_view format) {
  std::string words = stated            ? length_in_words(*stated) + " (stated by the file)"
                      : format == "fbx" ? "1 cm (usual in FBX; the file states none)"
                                        : "";
  if (words.empty()) return fmt::format("{:.6g} m", metres);
  if (stated == 1.0 && metres == 1.0) return words;
  words += ", converted to m";
  // The figure would be far from human height otherwise.
  if (metres != 1.0) words += fmt::format(" and then scaled by {:.6g}", metres);
  return words;
}

void show_rig(const motion::MotionSummary& summary, std::optional<double> stated_unit,
              std::string_view format, const Console& console) {
  console.out << fmt::format("rig      {}, {} joints", summary.rig, summary.joint_names.size());
  if (summary.is_human)
    console.out << fmt::format(", recognised with {:.0f} % confidence", 100.0 * summary.confidence);
  console.out << fmt::format("\nunit     {}, up {}\n",
                             unit_in_words(summary.unit_m, stated_unit, format), summary.up);
}

/// Of a file of points, rig and unit are those of the body that was fitted, and tell nothing.
void show_text(const motion::MotionSummary& summary, bool is_of_points,
               std::optional<double> stated_unit, std::string_view format, const Console& console) {
  console.out << fmt::format("frames   {} at {:.4g} frames per second, {:.2f} s\n", summary.frames,
                             summary.frames_per_second, summary.duration_seconds);
  if (summary.takes.size() > 1)
    console.out << fmt::format("takes    {} (showing {})\n", fmt::join(summary.takes, ", "),
                               summary.take);
  if (!is_of_points) show_rig(summary, stated_unit, format, console);
  if (summary.is_human) {
    console.out << fmt::format("figure   {:.2f} m tall without soles, moving at {:.2f} m/s\n",
                               summary.height_m, summary.speed_m_s);
    if (!is_of_points) show_mapping(summary, console);
    show_hands(summary, console);
    show_cycles(summary, console);
  }
  for (const std::string& warning : summary.warnings) console.out << "warning: " << warning << '\n';
}

/// What a file of points holds, and how the body was fitted to it.
struct PointsSummary {
  motion::PointRecording points;
  motion::MarkerSet set;
  motion::GapSummary gaps;
  motion::PointAxes axes;
  std::optional<motion::FittedMotion> fit;
};

ordered_json as_json(const PointsSummary& summary) {
  ordered_json points = ordered_json::array();
  for (std::size_t i = 0; i < summary.points.points.size(); ++i) {
    ordered_json point = {{"point", summary.points.points[i]},
                          {"missing_share", rounded(summary.gaps.points[i].missing_share)},
                          {"longest_gap_s", rounded(summary.gaps.points[i].longest_gap_seconds)}};
    if (summary.fit) {
      const motion::FittedPoint& fitted = summary.fit->points[i];
      if (fitted.use == motion::PointUse::used) {
        point["role"] = fitted.role;
        point["residual_mm"] = rounded(fitted.residual_mm);
      }
    }
    points.push_back(std::move(point));
  }
  ordered_json events = ordered_json::array();
  for (const motion::PointEvent& event : summary.points.events)
    events.push_back(
        {{"event", event.label}, {"context", event.context}, {"time_s", rounded(event.seconds)}});
  ordered_json result = {
      {"marker_set", summary.set.name},
      {"unit", summary.points.unit},
      {"unit_m", summary.axes.metres_per_unit},
      {"up", summary.axes.up},
      {"up_assumed", summary.axes.is_up_assumed},
      {"up_stated", summary.points.stated_up.empty() ? ordered_json(nullptr)
                                                     : ordered_json(summary.points.stated_up)},
      {"missing_share", rounded(summary.gaps.missing_share)},
      {"longest_gap_s", rounded(summary.gaps.longest_gap_seconds)},
      {"points", points},
      {"events", events}};
  result["fit_residual_mm"] = nullptr;
  if (summary.fit) result["fit_residual_mm"] = rounded(summary.fit->residual_mm);
  return result;
}

std::size_t point_of_longest_gap(const motion::GapSummary& gaps) {
  const auto longest = std::ranges::max_element(
      gaps.points, {}, [](const motion::PointGaps& each) { return each.longest_gap_seconds; });
  return static_cast<std::size_t>(longest - gaps.points.begin());
}

void show_fit(const motion::FittedMotion& fit, const Console& console) {
  console.out << fmt::format("fit      {:.1f} mm (root mean square of all points)",
                             fit.residual_mm);
  const auto worst = std::ranges::max_element(fit.points, {}, &motion::FittedPoint::residual_mm);
  if (worst != fit.points.end() && worst->residual_mm > 0.0)
    console.out << fmt::format("; largest {}: {:.1f} mm", worst->name, worst->residual_mm);
  console.out << '\n';
}

std::string unit_name(double metres) {
  if (metres == 1.0) return "m";
  if (metres == 0.01) return "cm";
  if (metres == 0.001) return "mm";
  return fmt::format("{:.6g} m", metres);
}

/// "Left Foot Strike 1.00 s, Right Foot Off 1.50 s, … (12 in all)"
std::string events_in_words(const std::vector<motion::PointEvent>& events) {
  constexpr std::size_t most = 6;
  std::vector<std::string> words;
  for (const motion::PointEvent& event : events) {
    if (words.size() == most) {
      words.push_back(fmt::format("… ({} in all)", events.size()));
      break;
    }
    words.push_back(fmt::format("{}{}{} {:.2f} s", event.context, event.context.empty() ? "" : " ",
                                event.label, event.seconds));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// The first names on lines of at most 90 columns: "  LASI, RASI, … and 27 more"
void show_point_names(const std::vector<std::string>& names, const Console& console) {
  constexpr std::size_t most = 12;
  constexpr std::size_t widest = 90;
  std::string line = " ";
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    const bool is_last = i + 1 == names.size();
    const std::string word = " " + motion::excerpt(names[i]) + (is_last ? "" : ",");
    if (line.size() + word.size() > widest && line.size() > 1) {
      console.out << line << '\n';
      line = " ";
    }
    line += word;
  }
  if (names.size() > most) {
    line.back() = ' ';
    line += fmt::format("and {} more (all with --json)", names.size() - most);
  }
  console.out << line << '\n';
}

void show_text(const PointsSummary& summary, const Console& console) {
  const motion::PointRecording& points = summary.points;
  console.out << fmt::format("points   {}, {}\n", points.point_count(),
                             summary.set.name.empty() ? "no known marker set" : summary.set.name);
  show_point_names(points.points, console);
  console.out << fmt::format("axes     {} up{}, in {}\n", summary.axes.up,
                             summary.axes.is_up_assumed  ? " (assumed)"
                             : summary.axes.is_up_stated ? " (stated by the file)"
                                                         : "",
                             points.unit.empty()
                                 ? "a unit that the file does not state, taken to be " +
                                       unit_name(summary.axes.metres_per_unit)
                                 : points.unit);
  if (summary.gaps.missing_share > 0.0)
    console.out << fmt::format("missing  {:.1f} %, longest gap {:.2f} s ({})\n",
                               100.0 * summary.gaps.missing_share, summary.gaps.longest_gap_seconds,
                               points.points[point_of_longest_gap(summary.gaps)]);
  if (!points.events.empty())
    console.out << fmt::format("events   {}\n", events_in_words(points.events));
  if (summary.fit) show_fit(*summary.fit, console);
}

void show_people(const motion::Recording& recording, const Console& console) {
  if (recording.subjects.empty()) return;
  console.out << fmt::format("people   {}", fmt::join(recording.subjects, ", "));
  if (recording.subjects.size() > 1)
    console.out << fmt::format(" (showing {})",
                               recording.subject.empty() ? "all" : recording.subject);
  console.out << '\n';
}

motion::FileContents contents_of(const NamedRecording& named) {
  try {
    return motion::read_file(named.file, named.how);
  } catch (const Error& error) {
    if (named.how.subject != "all") throw;
    throw Error(error.what(), "only mien render shows everyone with --subject all");
  }
}

int show_info(const InfoOptions& options, const Console& console) {
  const NamedRecording named = named_recording(options.file, options.recording);
  motion::FileContents contents = contents_of(named);
  std::optional<PointsSummary> points;
  motion::Recording recording;
  if (auto* found = std::get_if<motion::PointRecording>(&contents)) {
    motion::RecordedPoints motion = motion::recorded_points(*found);
    points =
        PointsSummary{*found, motion::recognised_marker_set(found->points), motion::gaps_of(*found),
                      motion::point_axes(*found), std::move(motion.fit)};
    recording = std::move(motion.recording);
  } else {
    recording = std::get<motion::Recording>(std::move(contents));
  }
  const motion::MotionSummary summary = motion::summarise(recording);
  const std::optional<double> stated_unit = motion::stated_unit(named.file);
  if (options.json) {
    ordered_json json = as_json(summary);
    json["people"] = recording.subjects;
    json["person"] = nullptr;
    if (!recording.subject.empty()) json["person"] = recording.subject;
    json["stated_unit_m"] = nullptr;
    if (stated_unit) json["stated_unit_m"] = *stated_unit;
    if (points) json["recorded"] = as_json(*points);
    json["drives"] = ordered_json::array();
    if (summary.is_human) json["drives"] = drives_as_json(clip_of(recording));
    console.out << json.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
  } else {
    show_people(recording, console);
    if (points) show_text(*points, console);
    show_text(summary, points.has_value(), stated_unit, recording.format, console);
    if (summary.is_human) show_drives(clip_of(recording), console);
  }
  return exit_done;
}

}  // namespace

Command motion_info_command() {
  const auto options = std::make_shared<InfoOptions>();
  return {.name = "info",
          .summary = "Show the contents of a motion file and how its rig was recognised",
          .options = all_of(argument("file", &options->file, "Motion file"),
                            recording_options(options->recording),
                            flag("--json", &options->json, "As JSON")),
          .notes = "Example:\n  mien motion info walk.bvh --json | jq .speed_m_s",
          .run = [options](const Console& console) { return show_info(*options, console); }};
}

}  // namespace mien::pipeline
