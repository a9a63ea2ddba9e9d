#include "pipeline/production/sheets/sheet.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "motion/measures/distance/hands_distance.h"
#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

constexpr int pixels_wide = 3508;  // A4 at 300 dots an inch

std::string drawn(Canvas& canvas, const SheetContent& content) {
  const SheetLayout page = sheet_layout();
  draw_header(canvas, content, page.header);
  draw_verdict(canvas, content, page.verdict);
  draw_settings(canvas, content, page.settings);
  draw_figures(canvas, content, page.figures);
  draw_heat_map(canvas, content, page.heat_map);
  draw_joint_bars(canvas, content, page.joint_bars);
  draw_curves(canvas, content, page.curves);
  draw_footer(canvas, content, page.footer);
  return canvas.finish();
}

}  // namespace

std::string verdict(const motion::Distance& distance) {
  const double threshold = motion::distance_threshold_m;
  // Rounded to millimetres a distance just below the threshold would read as the threshold.
  int digits = 3;
  const auto printed = [&] { return std::stod(fmt::format("{:.{}f}", distance.mean, digits)); };
  while (digits < 12 && (printed() < threshold) != distance.matches()) ++digits;
  return fmt::format("{} the matching threshold: D = {:.{}f} m {} {:g} m",
                     distance.matches() ? "Below" : "Not below", distance.mean, digits,
                     distance.matches() ? "<" : "≥", threshold);
}

std::string largest_distance_text(const motion::Distance& distance) {
  const auto by_joint = distance.by_joint();
  const auto worst = std::max_element(by_joint.begin(), by_joint.end());
  std::string joint = spoken_name(motion::BodyJoint(worst - by_joint.begin() + 1));
  joint[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(joint[0])));
  return fmt::format("largest mean distance: {}, {:.3f} m", joint, *worst);
}

std::string durations_text(const motion::Example& target, const motion::Example& created) {
  const double wanted = target.clip.duration_seconds();
  const double came = created.clip.duration_seconds();
  return fmt::format("durations: target {:.2f} s, created {:.2f} s ({:+.2f} s)", wanted, came,
                     came - wanted);
}

std::string fingertips_text(const motion::Example& target, const motion::Example& created) {
  const std::optional<double> apart = motion::hands_distance(target, created);
  return apart ? fmt::format("fingertips {:.3f} m apart", *apart) : "";
}

std::string beside_verdict(const motion::Distance& distance, const motion::Example& target,
                           const motion::Example& created) {
  const std::string fingertips = fingertips_text(target, created);
  return largest_distance_text(distance) + "  ·  " + durations_text(target, created) +
         (fingertips.empty() ? "" : "  ·  " + fingertips);
}

std::string sheet_as_pdf(const SheetContent& content) {
  const SheetLayout page = sheet_layout();
  const std::string title = content.created.id + " compared with " + content.target.id;
  return drawn(*Canvas::pdf(page.width, page.height, title), content);
}

std::string sheet_as_png(const SheetContent& content) {
  const SheetLayout page = sheet_layout();
  return drawn(*Canvas::png(page.width, page.height, pixels_wide), content);
}

}  // namespace mien::pipeline
