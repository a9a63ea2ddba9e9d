#include "pipeline/production/report/lint_timeline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "motion/lint/lint.h"
#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

namespace {

constexpr double page_width = 720.0;
constexpr double margin = 24.0;
constexpr double plot_left = 236.0;
constexpr double plot_right = page_width - 30.0;
constexpr double plot_top = 88.0;
constexpr double row_height = 17.0;
constexpr double least_bar = 2.5;  // points; a single frame of a long take would not be seen
constexpr int most_ticks = 8;
constexpr Colour error_colour = from_hex(0x9c2a10);
constexpr Colour warning_colour = from_hex(0xf0b640);

/// The findings of one rule and joint.
struct Row {
  std::string check;
  std::string joint;
  std::vector<const motion::Finding*> findings;
};

/// In the order of the findings, which is that of the rules; rows of one rule by their joints.
std::vector<Row> rows_of(const std::vector<motion::Finding>& findings) {
  std::vector<std::string> checks;
  std::map<std::pair<std::ptrdiff_t, std::string>, Row> rows;
  for (const motion::Finding& finding : findings) {
    auto check = std::ranges::find(checks, finding.check);
    if (check == checks.end()) check = checks.insert(check, finding.check);
    Row& row = rows[{check - checks.begin(), finding.joint}];
    row.check = finding.check;
    row.joint = finding.joint;
    row.findings.push_back(&finding);
  }
  std::vector<Row> ordered;
  for (auto& [place, row] : rows) ordered.push_back(std::move(row));
  return ordered;
}

struct Layout {
  Box plot;
  int frames = 1;
  double rate = 30.0;

  double x_of(double frame) const { return plot.x + plot.width * frame / frames; }
};

void draw_legend(Canvas& canvas, double right) {
  const TextStyle style = {.size = 8.5, .colour = quiet_ink};
  double x = right - canvas.text_width("warning", style);
  canvas.text({x, 48.0}, "warning", style);
  canvas.fill(Box{x - 20.0, 42.0, 15.0, 5.0}, warning_colour, 1.0);
  x -= 34.0 + canvas.text_width("error", style);
  canvas.text({x, 48.0}, "error", style);
  canvas.fill(Box{x - 20.0, 39.0, 15.0, 11.0}, error_colour, 1.0);
}

void draw_axes(Canvas& canvas, const Layout& layout) {
  const TextStyle label = {.size = 8.0, .colour = quiet_ink, .align = Align::centre};
  const double seconds = layout.frames / layout.rate;
  for (const double tick : axis_ticks(seconds, most_ticks)) {
    if (tick > seconds + 1e-9) continue;
    const double x = layout.x_of(tick * layout.rate);
    canvas.line({x, layout.plot.y}, {x, layout.plot.bottom()}, {.width = 0.5, .colour = hairline});
    canvas.text({x, layout.plot.bottom() + 13.0}, fmt::format("{:g}", tick), label);
    canvas.text({x, layout.plot.y - 6.0}, fmt::format("{:.0f}", tick * layout.rate), label);
  }
  const TextStyle unit = {.size = 8.0, .colour = quiet_ink, .align = Align::right};
  canvas.text({layout.plot.x - 12.0, layout.plot.bottom() + 13.0}, "seconds", unit);
  canvas.text({layout.plot.x - 12.0, layout.plot.y - 6.0}, "frame", unit);
}

void draw_bar(Canvas& canvas, const Layout& layout, double top, int first, int last,
              bool is_error) {
  const double from = layout.x_of(first);
  const double length = std::max(layout.x_of(last + 1) - from, least_bar);
  const double height = is_error ? 12.0 : 6.0;
  canvas.fill(Box{from, top + 0.5 * (row_height - height), length, height},
              is_error ? error_colour : warning_colour, 1.0);
}

/// A finding that runs over a loop's seam goes on at the start.
void draw_finding(Canvas& canvas, const Layout& layout, double top,
                  const motion::Finding& finding) {
  const bool is_error = finding.severity == motion::Severity::error;
  const int end = layout.frames - 1;
  draw_bar(canvas, layout, top, finding.first, std::min(finding.last, end), is_error);
  if (finding.last > end) {
    draw_bar(canvas, layout, top, 0, finding.last - layout.frames, is_error);
  }
}

void draw_row(Canvas& canvas, const Layout& layout, double top, const Row& row,
              bool names_the_rule) {
  const double baseline = top + 0.5 * row_height + 3.0;
  if (names_the_rule) {
    canvas.line({margin, top}, {layout.plot.right(), top}, {.width = 0.5, .colour = hairline});
    canvas.text({margin, baseline}, row.check, {.size = 8.5, .bold = true, .max_width = 100.0});
  }
  canvas.text({margin + 104.0, baseline}, row.joint.empty() ? "whole body" : row.joint,
              {.size = 8.0, .colour = quiet_ink, .max_width = 104.0});
  // Warnings last would hide errors.
  for (const auto severity : {motion::Severity::warning, motion::Severity::error}) {
    for (const motion::Finding* finding : row.findings) {
      if (finding->severity == severity) draw_finding(canvas, layout, top, *finding);
    }
  }
}

std::string subtitle_of(const LintedMotion& motion) {
  const auto errors =
      std::ranges::count(motion.findings, motion::Severity::error, &motion::Finding::severity);
  const auto warnings = static_cast<long>(motion.findings.size()) - errors;
  return fmt::format(
      "{} {}, {} {}; {} frames at {:g} per second", errors, errors == 1 ? "error" : "errors",
      warnings, warnings == 1 ? "warning" : "warnings", motion.frames, motion.frames_per_second);
}

/// Names of the rules that looked and found nothing, in lines that fit the page.
std::vector<std::string> clean_lines(const LintedMotion& motion) {
  std::vector<std::string> lines = {"rules without findings:"};
  for (const motion::LintCheck& check : motion::lint_checks()) {
    const bool has_findings =
        std::ranges::count(motion.findings, check.id, &motion::Finding::check) > 0;
    const bool looked = (!check.needs_original || motion.was_compared) &&
                        (check.id != "loop-seam" || motion.loops) &&
                        (check.id != "fit-residual" || motion.is_fitted);
    if (has_findings || !looked) continue;
    if (lines.back().size() + check.id.size() > 120) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : "  ") + std::string(check.id);
  }
  return lines;
}

}  // namespace

Plot lint_timeline(const LintedMotion& motion) {
  const std::vector<Row> rows = rows_of(motion.findings);
  const std::vector<std::string> clean = clean_lines(motion);
  const double plot_height = row_height * std::max<double>(1.0, static_cast<double>(rows.size()));
  const double height = plot_top + plot_height + 40.0 + 12.0 * static_cast<double>(clean.size());
  Plot plot{"Findings over time: " + motion.name, page_width, height, {}};
  // The rows point into the plot's own copy of the findings.
  plot.draw = [motion, plot_height, clean](Canvas& canvas) {
    canvas.text({margin, 30.0}, motion.name,
                {.size = 13.0, .bold = true, .max_width = page_width - 2 * margin});
    canvas.text({margin, 48.0}, subtitle_of(motion), {.size = 8.5, .colour = quiet_ink});
    draw_legend(canvas, plot_right);
    const Layout layout = {{plot_left, plot_top, plot_right - plot_left, plot_height},
                           std::max(motion.frames, 1),
                           motion.frames_per_second};
    draw_axes(canvas, layout);
    double top = plot_top;
    std::string check;
    for (const Row& row : rows_of(motion.findings)) {
      draw_row(canvas, layout, top, row, row.check != check);
      check = row.check;
      top += row_height;
    }
    const double below = plot_top + plot_height;
    canvas.line({margin, below}, {plot_right, below}, {.width = 0.5, .colour = hairline});
    double baseline = below + 34.0;
    for (const std::string& line : clean) {
      canvas.text({margin, baseline}, line, {.size = 8.0, .colour = quiet_ink});
      baseline += 12.0;
    }
  };
  return plot;
}

}  // namespace mien::pipeline
