#include "pipeline/production/report/recordings_section.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/report/fit_chart.h"
#include "pipeline/production/synthesis/fitted_recordings.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_names = 6;
/// Metrics/fits.csv has all.
constexpr std::size_t most_fits = 60;

std::string file_name(const std::filesystem::path& file) {
  return html_escaped(file.filename().string());
}

/// "a.bvh, b.bvh and 28 more"
std::string first_names(const std::vector<std::string>& names) {
  const std::size_t shown = names.size() <= most_names + 1 ? names.size() : most_names;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(shown));
  const std::string text = fmt::format("{}", fmt::join(first, ", "));
  return shown == names.size() ? text : fmt::format("{} and {} more", text, names.size() - shown);
}

/// A row for each licence and source. Empty if the manifest states none.
std::string licence_table(const Manifest& manifest) {
  std::map<std::tuple<std::string, bool, std::string>, std::vector<std::string>> files;
  for (const RecordingFile& recording : recording_files(manifest))
    files[{recording.licence.name, recording.licence.share, recording.source}].push_back(
        file_name(recording.file));
  const bool is_any_stated = std::ranges::any_of(files, [](const auto& entry) {
    return !std::get<0>(entry.first).empty() || !std::get<2>(entry.first).empty();
  });
  if (!is_any_stated) return "";
  std::string rows;
  for (const auto& [terms, names] : files) {
    const auto& [licence, share, source] = terms;
    rows += fmt::format("<tr><td>{}</td><td>{}{}</td><td>{}</td></tr>\n", first_names(names),
                        licence.empty() ? "not stated" : html_escaped(licence),
                        share ? "" : " (not to be shared)", html_escaped(source));
  }
  return html_table({"recordings", "licence", "source"}, rows);
}

/// "3 gaps, 0.15 s"; empty for none.
std::string gaps_text(const motion::FittedPoint& point, bool filled, double rate) {
  int count = 0, frames = 0;
  for (const motion::PointGap& gap : point.gaps) {
    if (gap.filled != filled) continue;
    ++count;
    frames += gap.past - gap.first;
  }
  if (count == 0) return "";
  return fmt::format("{} {}, {:.2f} s", count, count == 1 ? "gap" : "gaps", frames / rate);
}

std::string point_row(const motion::FittedPoint& point, double rate) {
  const bool is_used = point.use == motion::PointUse::used;
  const bool is_far = point.residual_mm > motion::far_from_points_mm;
  const char* role = point.use == motion::PointUse::missing   ? " (missing in all frames)"
                     : point.use == motion::PointUse::unknown ? "not used"
                                                              : "";
  const std::string residual = is_used ? fmt::format("{:.1f}", point.residual_mm) : "";
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      html_escaped(point.name), html_escaped(point.role), role,
      is_far ? "<b>" + residual + "</b>" : residual, gaps_text(point, true, rate),
      gaps_text(point, false, rate));
}

/// "Plug-in Gait, 39 of 41 points used, RMS 14.1 mm; largest: LCAL 71.0 mm"
std::string summary_of(const motion::FitQuality& fit) {
  const auto used =
      std::ranges::count(fit.points, motion::PointUse::used, &motion::FittedPoint::use);
  const auto worst = std::ranges::max_element(fit.points, {}, &motion::FittedPoint::residual_mm);
  return fmt::format("{}, {} of {} points used, RMS {:.1f} mm; largest: {} {:.1f} mm",
                     html_escaped(fit.marker_set), used, fit.points.size(), fit.residual_mm,
                     html_escaped(worst->name), worst->residual_mm);
}

std::string fit_card(const FittedRecording& recording) {
  const motion::FitQuality& fit = recording.fit;
  std::string rows;
  for (const motion::FittedPoint& point : fit.points)
    rows += point_row(point, fit.frames_per_second);
  std::string people;
  if (recording.how.subject) people = " (" + html_escaped(*recording.how.subject) + ")";
  std::vector<std::string> users;
  for (const std::string& user : recording.used_by) users.push_back(html_escaped(user));
  return fmt::format("<details><summary>{}{}: {}</summary>\n", file_name(recording.file), people,
                     summary_of(fit)) +
         embedded_svg(as_svg(fit_chart(fit)), "Distance of the body from the points over time") +
         fmt::format(
             "<p>Used by {}. Frames {} to {} of {} (counted from 0). Gaps in the middle of up "
             "to 0.2 s were filled; in longer ones the point was not used.</p>\n",
             first_names(users), fit.first_frame,
             fit.first_frame + static_cast<int>(fit.frame_residual_mm.size()) - 1,
             fit.recorded_frames) +
         html_table({"point", "place on the body", ">RMS, mm", "filled", "missing"}, rows) +
         "</details>\n";
}

std::string fit_cards(const std::vector<FittedRecording>& recordings) {
  if (recordings.empty()) return "";
  std::string cards =
      "<p>A body was fitted to recorded points; RMS is the root mean square distance between "
      "points "
      "and body. All values: <a href=\"metrics/fits.csv\">fits.csv</a>.</p>\n";
  for (std::size_t i = 0; i < std::min(recordings.size(), most_fits); ++i)
    cards += fit_card(recordings[i]);
  if (recordings.size() > most_fits)
    cards += fmt::format("<p>{} more recordings are in fits.csv only.</p>\n",
                         recordings.size() - most_fits);
  return cards;
}

}  // namespace

std::string recordings_section(const Manifest& manifest, Motions& motions) {
  const std::string content =
      licence_table(manifest) + fit_cards(fitted_recordings(manifest, motions));
  return content.empty() ? "" : "<section><h2>Recordings</h2>\n" + content + "</section>\n";
}

}  // namespace mien::pipeline
