#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/utf8.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/power/power_output.h"

namespace mien::pipeline {

namespace {

constexpr double margin = 24.0;
constexpr double header_height = 74.0;
constexpr double panel_width = 190.0;
constexpr double panel_height = 118.0;
constexpr double panel_step_x = 240.0;
constexpr double panel_step_y = 204.0;
constexpr double note_height = 11.0;
constexpr std::size_t most_in_row = 3;

/// A test on a scale, with its rows by line.
struct PowerPanel {
  std::string title, scale;
  bool is_contrast = false;
  /// By number of stimuli per cell and way of testing, in the order of participants.
  std::map<std::pair<int, TestedBy>, std::vector<const PlannedTestPower*>> lines;
};

std::vector<PowerPanel> panels_of(const std::vector<PlannedTestPower>& rows) {
  std::vector<PowerPanel> panels;
  for (const bool are_contrasts : {true, false}) {
    for (const PlannedTestPower& row : rows) {
      if (row.is_contrast != are_contrasts || row.studies == 0) continue;
      auto found = std::ranges::find_if(panels, [&](const PowerPanel& one) {
        return one.is_contrast == row.is_contrast && one.title == row.name &&
               one.scale == row.scale;
      });
      if (found == panels.end())
        found = panels.insert(panels.end(), {row.name, row.scale, row.is_contrast, {}});
      found->lines[{row.stimuli_per_cell, row.by}].push_back(&row);
    }
  }
  return panels;
}

std::string label_of(int stimuli) {
  if (stimuli == 0) return "as planned";
  return stimuli == 1 ? "1 stimulus" : fmt::format("{} stimuli", stimuli);
}

/// What the lines of all panels share.
struct PowerAxes {
  std::vector<int> participants;
  std::vector<int> stimuli;
  double wanted = 0.8;

  double x(const Box& plot, int count) const {
    const double first = participants.front();
    const double range = std::max(1, participants.back() - participants.front());
    return plot.x + plot.width * (0.04 + 0.92 * (count - first) / range);
  }
  static double y(const Box& plot, double share) { return plot.bottom() - plot.height * share; }

  Colour colour(int count) const {
    const auto place = std::ranges::find(stimuli, count) - stimuli.begin();
    if (stimuli.size() == 1) return created_colours.line;
    return amount_colour(0.35 + 0.6 * static_cast<double>(place) /
                                    static_cast<double>(stimuli.size() - 1));
  }
};

/// The words of a text in lines, each as long as `fits` allows, but at most `most` lines: the last
/// one has all that is left.
std::vector<std::string> text_lines(const std::string& text, std::size_t most, auto&& fits) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t space = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, space - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || lines.size() == most || fits(longer))
      lines.back() = longer;
    else
      lines.push_back(word);
    at = space + 1;
  }
  return lines;
}

/// Notes in lines that are not wider than `width`, judged by their numbers of characters, since the
/// height of a page must be known before it is drawn.
std::vector<std::string> note_lines(const std::vector<std::string>& notes, double width) {
  constexpr double widest_mean_character = 4.3;  // points, of text of 8 points
  std::vector<std::string> all;
  for (const std::string& note : notes) {
    const std::vector<std::string> lines = text_lines(note, 8, [&](const std::string& line) {
      return widest_mean_character * static_cast<double>(count_characters(line)) <= width;
    });
    all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

void draw_title(Canvas& canvas, const PowerPanel& panel, const Box& plot) {
  const TextStyle style = {.size = 9.0, .bold = true, .max_width = panel_width};
  const std::vector<std::string> lines = text_lines(panel.title, 2, [&](const std::string& line) {
    return canvas.text_width(line, style) <= style.max_width;
  });
  double y = plot.y - 20.0 - 11.0 * static_cast<double>(lines.size() - 1);
  for (const std::string& line : lines) {
    canvas.text({plot.x, y}, line, style);
    y += 11.0;
  }
}

void draw_frame(Canvas& canvas, const PowerPanel& panel, const Box& plot, const PowerAxes& axes) {
  draw_title(canvas, panel, plot);
  canvas.text({plot.x, plot.y - 8.0},
              panel.scale + (panel.is_contrast ? ", planned contrast" : ", effect"),
              {.size = 7.5, .colour = quiet_ink, .max_width = panel_width});
  for (const double tick : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double at = PowerAxes::y(plot, tick);
    canvas.line({plot.x, at}, {plot.right(), at}, {.width = 0.5, .colour = hairline});
    canvas.text({plot.x - 5.0, at + 2.6}, fmt::format("{:.0f}", 100.0 * tick),
                {.size = 7.5, .colour = quiet_ink, .align = Align::right});
  }
  const double wanted = PowerAxes::y(plot, axes.wanted);
  canvas.line({plot.x, wanted}, {plot.right(), wanted}, {.width = 0.9, .colour = quiet_ink});
  double free_from = 0.0;
  for (const int count : axes.participants) {
    const double at = axes.x(plot, count);
    if (at < free_from) continue;
    canvas.text({at, plot.bottom() + 11.0}, std::to_string(count),
                {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
    free_from = at + 20.0;
  }
  canvas.text({plot.x + 0.5 * plot.width, plot.bottom() + 23.0}, "participants",
              {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
}

void draw_lines(Canvas& canvas, const PowerPanel& panel, const Box& plot, const PowerAxes& axes) {
  for (const auto& [which, rows] : panel.lines) {
    const Colour colour = axes.colour(which.first);
    const bool is_dashed = which.second == TestedBy::participants;
    std::vector<Point> points;
    for (const PlannedTestPower* row : rows) {
      const double x = axes.x(plot, row->participants);
      points.push_back({x, PowerAxes::y(plot, row->power.share)});
      canvas.line({x, PowerAxes::y(plot, row->power.low)}, {x, PowerAxes::y(plot, row->power.high)},
                  {.width = 0.8, .colour = colour});
    }
    canvas.polyline(points, {.width = 1.3, .colour = colour, .dashed = is_dashed});
    for (const Point& point : points) canvas.disc(point, 1.7, colour);
  }
}

/// The key: a sample of each line, from the left.
void draw_key(Canvas& canvas, const PowerAxes& axes, bool has_both, double width) {
  double x = margin;
  double y = margin + 46.0;
  const auto add = [&](const std::string& text, const Colour& colour, bool is_dashed) {
    const TextStyle style = {.size = 8.0};
    const double length = 26.0 + canvas.text_width(text, style) + 14.0;
    if (x + length > width - margin) {
      x = margin;
      y += 12.0;
    }
    canvas.line({x, y - 2.8}, {x + 20.0, y - 2.8},
                {.width = 1.3, .colour = colour, .dashed = is_dashed});
    canvas.text({x + 26.0, y}, text, style);
    x += length;
  };
  if (axes.stimuli.size() > 1)
    for (const int count : axes.stimuli)
      add(label_of(count) + (count == 0 ? "" : " per cell"), axes.colour(count), false);
  if (has_both) add("participants and stimuli random", ink, false);
  add(has_both ? "participants random" : "participants random, stimuli fixed", ink, true);
}

}  // namespace

Plot power_chart(const std::string& study, const std::vector<PlannedTestPower>& rows,
                 double wanted_power, const std::vector<std::string>& notes) {
  std::vector<PowerPanel> panels = panels_of(rows);
  const std::size_t omitted =
      panels.size() > most_power_panels ? panels.size() - most_power_panels : 0;
  panels.resize(panels.size() - omitted);
  std::set<int> participants, stimuli;
  bool has_both = false;
  for (const PlannedTestPower& row : rows) {
    participants.insert(row.participants);
    stimuli.insert(row.stimuli_per_cell);
    has_both = has_both || row.by == TestedBy::participants_and_stimuli;
  }
  const PowerAxes axes{
      {participants.begin(), participants.end()}, {stimuli.begin(), stimuli.end()}, wanted_power};
  const std::size_t columns = std::clamp<std::size_t>(panels.size(), 2, most_in_row);
  const std::size_t lines = (panels.size() + columns - 1) / columns;
  const double width = 2.0 * margin + panel_step_x * static_cast<double>(columns);
  std::vector<std::string> below = note_lines(notes, width - 2.0 * margin);
  if (omitted > 0) below.push_back(fmt::format("{} more tests are in the table.", omitted));
  const double height = 2.0 * margin + header_height + panel_step_y * static_cast<double>(lines) +
                        note_height * static_cast<double>(below.size());
  // The panels refer to the rows, which the drawing therefore keeps.
  const auto kept = std::vector<PlannedTestPower>(rows);
  return {"Power of the planned tests", width, height, [=](Canvas& canvas) {
            canvas.text({margin, margin + 12.0}, "Power of the planned tests: " + study,
                        {.size = 12.0, .bold = true, .max_width = width - 2.0 * margin - 110.0});
            canvas.text({margin, margin + 28.0},
                        "simulated studies in which the test is significant, percent, with 95 % "
                        "Monte-Carlo intervals",
                        {.size = 8.5, .colour = quiet_ink});
            draw_simulated_mark(canvas, {width - margin, margin}, "Simulated studies");
            draw_key(canvas, axes, has_both, width);
            const std::vector<PowerPanel> drawn = panels_of(kept);
            for (std::size_t i = 0; i + omitted < drawn.size(); ++i) {
              const Box plot{
                  margin + 30.0 + panel_step_x * static_cast<double>(i % columns),
                  margin + header_height + 30.0 + panel_step_y * static_cast<double>(i / columns),
                  panel_width, panel_height};
              draw_frame(canvas, drawn[i], plot, axes);
              draw_lines(canvas, drawn[i], plot, axes);
            }
            double y = height - margin - note_height * static_cast<double>(below.size());
            for (const std::string& note : below)
              canvas.text({margin, y += note_height}, note,
                          {.size = 8.0, .colour = quiet_ink, .max_width = width - 2.0 * margin});
          }};
}

}  // namespace mien::pipeline
