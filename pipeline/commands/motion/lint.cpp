#include "motion/lint/lint.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/lint/fit_residuals.h"
#include "motion/rig/recording_clip.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"
#include "pipeline/production/report/lint_timeline.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct LintCommand {
  std::vector<std::string> files;
  std::string original;
  RecordingArguments of_original;
  std::string timeline;
  RecordingArguments recording;
  double mass_kg = motion::LintOptions().body_mass_kg;
  bool loop = false;
  bool errors_only = false;
  bool json = false;
  bool csv = false;
};

/// A motion file and its findings.
struct LintedFile {
  std::string file;
  std::string take;    ///< where the file holds several
  std::string person;  ///< where the file holds several
  bool is_human = false;
  LintedMotion motion;
};

/// The clip as one cycle of a loop: its last frame is followed by its first, displaced by one step.
motion::Clip as_loop(motion::Clip clip) {
  if (clip.frame_count() < 3)
    throw Error(fmt::format("\"{}\" has {} frames", clip.name, clip.frame_count()),
                "a loop needs at least 3; omit --loop");
  const motion::Vec3& last = clip.poses.back().root_position;
  motion::Vec3 way = 2.0 * last - clip.poses[clip.poses.size() - 2].root_position -
                     clip.poses.front().root_position;
  way.y() = 0.0;
  // What is left of a walk in place is sway, not a way.
  constexpr double slowest = 0.15;  // m/s
  clip.loops = true;
  clip.cycle_displacement =
      way.norm() > slowest * clip.duration_seconds() ? way : motion::Vec3::Zero();
  return clip;
}

motion::Clip looped_if_requested(motion::Clip clip, bool loop) {
  return loop ? as_loop(std::move(clip)) : clip;
}

LintedFile linted(const NamedRecording& named, const LintCommand& command,
                  const motion::Clip* original, const Console& console) {
  motion::LintOptions options;
  options.body_mass_kg = command.mass_kg;
  const motion::FittedFile read = read_fitted_with_warnings(named, console);
  const motion::Recording& recording = read.recording;
  const motion::Clip clip = looped_if_requested(clip_of(recording), command.loop);
  LintedFile result;
  result.file = named.file;
  result.take = chosen_take(recording);
  result.person = chosen_person(recording);
  result.is_human = motion::is_body(clip.body);
  result.motion = {fs::path(named.file).stem().string(),
                   clip.frame_count(),
                   clip.frames_per_second,
                   original != nullptr,
                   {},
                   clip.loops,
                   read.fit.has_value()};
  std::vector<motion::Finding>& findings = result.motion.findings;
  // Putting it on the canonical body hides what its own bones do.
  if (result.is_human) findings = motion::lint(recording, options);
  const std::vector<motion::Finding> more = motion::lint(clip, options, original);
  findings.insert(findings.end(), more.begin(), more.end());
  if (read.fit) {
    const std::vector<motion::Finding> of_fit = motion::find_fit_residuals(*read.fit, clip);
    findings.insert(findings.end(), of_fit.begin(), of_fit.end());
  }
  if (command.errors_only) {
    std::erase_if(findings, [](const motion::Finding& finding) {
      return finding.severity != motion::Severity::error;
    });
  }
  return result;
}

long errors_in(const LintedFile& linted) {
  const auto& findings = linted.motion.findings;
  return std::count_if(findings.begin(), findings.end(), [](const motion::Finding& finding) {
    return finding.severity == motion::Severity::error;
  });
}

ordered_json as_json(const motion::Finding& finding) {
  return {{"check", finding.check},       {"joint", finding.joint},
          {"first", finding.first},       {"last", finding.last},
          {"measured", finding.measured}, {"threshold", finding.threshold},
          {"unit", finding.unit},         {"severity", motion::name_of(finding.severity)},
          {"sentence", finding.sentence}};
}

void show_json(const std::vector<LintedFile>& all, const Console& console) {
  ordered_json motions = ordered_json::array();
  for (const LintedFile& one : all) {
    ordered_json findings = ordered_json::array();
    for (const motion::Finding& finding : one.motion.findings) findings.push_back(as_json(finding));
    motions.push_back({{"file", one.file},
                       {"human", one.is_human},
                       {"frames", one.motion.frames},
                       {"frames_per_second", one.motion.frames_per_second},
                       {"errors", errors_in(one)},
                       {"findings", findings}});
    if (!one.take.empty()) motions.back()["take"] = one.take;
    if (!one.person.empty()) motions.back()["person"] = one.person;
  }
  const ordered_json result = {{"motions", motions}};
  console.out << result.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

struct FileFinding {
  std::string motion;
  const motion::Finding& found;
};

constexpr auto findings_columns = table_of<FileFinding>(
    "findings.csv", "finding",
    {{"motion", "", "name of the file", [](auto& r) { return r.motion; }},
     {"check", "", "lint rule", [](auto& r) { return r.found.check; }},
     {"joint", "", "joint, or recorded point; empty if none is concerned",
      [](auto& r) { return r.found.joint; }},
     {"first", "", "first frame", [](auto& r) { return r.found.first; }},
     {"last", "", "last frame", [](auto& r) { return r.found.last; }},
     {"measured", "see unit", "measured value", [](auto& r) { return r.found.measured; }},
     {"threshold", "see unit", "limit of the rule", [](auto& r) { return r.found.threshold; }},
     {"unit", "", "unit of value and limit", [](auto& r) { return r.found.unit; }},
     {"severity", "", "error or warning",
      [](auto& r) { return motion::name_of(r.found.severity); }},
     {"sentence", "", "description of the finding", [](auto& r) { return r.found.sentence; }}});

void show_csv(const std::vector<LintedFile>& all, const Console& console) {
  std::vector<FileFinding> rows;
  for (const LintedFile& one : all)
    for (const motion::Finding& finding : one.motion.findings)
      rows.push_back({one.motion.name, finding});
  console.out << findings_columns.of(rows).csv;
}

std::string counted(long count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void show_table(const std::vector<LintedFile>& all, const Console& console) {
  for (const LintedFile& one : all) {
    const long errors = errors_in(one);
    const long warnings = static_cast<long>(one.motion.findings.size()) - errors;
    console.out << fmt::format("{}: {}, {} ({} frames, {:.1f} s)\n", one.file,
                               counted(errors, "error"), counted(warnings, "warning"),
                               one.motion.frames, one.motion.frames / one.motion.frames_per_second);
    if (!one.is_human)
      console.out << "  no human body was recognised; only the data were checked\n";
    for (const motion::Finding& finding : one.motion.findings)
      console.out << fmt::format("  {:7}  {:>11}  {:18} {}\n", motion::name_of(finding.severity),
                                 fmt::format("{}–{}", finding.first, finding.last), finding.check,
                                 finding.sentence);
  }
}

void draw_timeline(const LintCommand& command, const LintedFile& linted) {
  const Plot plot = lint_timeline(linted.motion);
  const bool is_svg = fs::path(command.timeline).extension() == ".svg";
  write_file(command.timeline, is_svg ? as_svg(plot) : as_png(plot, 144.0));
}

void require_timeline(const LintCommand& command) {
  if (command.timeline.empty()) return;
  const std::string extension = fs::path(command.timeline).extension().string();
  if (extension != ".png" && extension != ".svg")
    throw Error(fmt::format("cannot draw \"{}\"", command.timeline),
                "timelines are .png or .svg files");
  if (command.files.size() == 1) return;
  throw Error(fmt::format("--timeline draws one motion, but {} were given", command.files.size()),
              "draw them one by one");
}

int show_findings(const LintCommand& command, const Console& console) {
  require_timeline(command);
  std::optional<motion::Clip> original;
  if (!command.original.empty()) {
    original =
        looped_if_requested(clip_of(read_with_warnings(
                                named_recording(command.original, command.of_original), console)),
                            command.loop);
    if (!motion::is_body(original->body))
      throw Error(fmt::format("no human body was recognised in \"{}\"", command.original),
                  "the original must be a human motion");
  }
  std::vector<LintedFile> all;
  for (const NamedRecording& named : named_recordings(command.files, command.recording))
    all.push_back(linted(named, command, original ? &*original : nullptr, console));
  if (command.json) {
    show_json(all, console);
  } else if (command.csv) {
    show_csv(all, console);
  } else {
    show_table(all, console);
  }
  if (!command.timeline.empty()) draw_timeline(command, all.front());
  const bool is_clean = std::all_of(all.begin(), all.end(),
                                    [](const LintedFile& one) { return errors_in(one) == 0; });
  return is_clean ? exit_done : exit_failed;
}

std::string footer() {
  std::string text = "Rules:\n";
  for (const motion::LintCheck& check : motion::lint_checks())
    text += fmt::format("  {:18} {}{}\n", check.id, check.what,
                        check.needs_original ? " (--original)" : "");
  return text +
         "\nExit code: 0 without errors (warnings are allowed), 1 with errors, 2 for bad input.\n\n"
         "Examples:\n"
         "  mien motion lint captures/*.bvh\n"
         "  mien motion lint sad.bvh --original walk.bvh --timeline faults.png\n"
         "  mien motion lint --csv out/*/clips/*.bvh > faults.csv";
}

}  // namespace

Command motion_lint_command() {
  const auto options = std::make_shared<LintCommand>();
  return {
      .name = "lint",
      .summary =
          "Find implausible movement: foot sliding, jumps, overstretched joints and other faults",
      .options = all_of(
          argument("files", &options->files, "Motion files"),
          options_of_recordings(options->recording),
          option("--original", &options->original,
                 "The unmodified motion; faults that it already has are reported only where they "
                 "have grown, and timing is compared"),
          option("--original-take", &options->of_original.takes,
                 "Motion to use from the --original file, if it has several; also as FILE#TAKE")
              .values(1, 1)
              .needs("--original"),
          option("--original-subject", &options->of_original.subjects,
                 "Person to use from the --original file, if it has several")
              .values(1, 1)
              .needs("--original"),
          option("--mass", &options->mass_kg,
                 "Body mass in kg; heavier bodies are allowed larger joint torques")
              .between(1.0, 500.0)
              .with_default(),
          flag("--loop", &options->loop,
               "Each file holds one cycle, whose last frame continues with the first"),
          flag("--errors-only", &options->errors_only, "Omit warnings"),
          option("--timeline", &options->timeline, "Draw the findings over time: .png or .svg"),
          flag("--json", &options->json, "As JSON"),
          flag("--csv", &options->csv, "As a table with one row per finding").excludes("--json")),
      .notes = footer(),
      .run = [options](const Console& console) { return show_findings(*options, console); }};
}

}  // namespace mien::pipeline
