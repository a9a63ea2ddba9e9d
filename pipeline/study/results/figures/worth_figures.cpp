#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

struct WorthLine {
  std::string name;
  std::string note;  ///< why there is no worth, or the group
  double worth;      ///< NaN: no worth
  Interval95 ends;
};

/// A row for each stimulus, on a common axis of log-worth.
struct WorthChart {
  std::string title;
  std::string words;  ///< subtitle
  std::vector<WorthLine> lines;
  double low = -1.0;  ///< ends of the axis
  double high = 1.0;
  double step = 0.5;  ///< distance of its ticks
};

constexpr double worth_margin = 18.0;
constexpr double worth_header = 52.0;
constexpr double worth_row_height = 19.0;
constexpr double worth_axis_height = 34.0;
constexpr double worth_least_axis = 300.0;
constexpr double worth_values_width = 104.0;

double names_width_of(const WorthChart& chart) {
  constexpr double letter = 4.6;
  std::size_t longest = 0;
  for (const WorthLine& line : chart.lines) longest = std::max(longest, line.name.size());
  return std::clamp(14.0 + letter * static_cast<double>(longest), 90.0, 200.0);
}

double page_width_of(const WorthChart& chart) {
  constexpr double least = 540.0;
  return std::max(
      2.0 * worth_margin + names_width_of(chart) + worth_least_axis + worth_values_width, least);
}

double axis_width_of(const WorthChart& chart) {
  return page_width_of(chart) - 2.0 * worth_margin - names_width_of(chart) - worth_values_width;
}

std::string signed_text(double value) {
  const std::string text = fmt::format("{:.2f}", std::abs(value));
  return (value < 0.0 && text != "0.00" ? "−" : "") + text;
}

void draw_axis(Canvas& canvas, const WorthChart& chart, const Box& area) {
  const auto x = [&](double worth) {
    return area.x + (worth - chart.low) / (chart.high - chart.low) * area.width;
  };
  for (double at = chart.low; at < chart.high + 0.5 * chart.step; at += chart.step) {
    const bool is_zero = std::abs(at) < 0.25 * chart.step;
    canvas.line({x(at), area.y}, {x(at), area.bottom()},
                {.width = is_zero ? 0.9 : 0.5, .colour = is_zero ? quiet_ink : hairline});
    const std::string text = fmt::format("{:g}", std::abs(at));
    canvas.text({x(at), area.bottom() + 11.0},
                (at < 0.0 && !is_zero ? "−" : "") + (is_zero ? "0" : text),
                {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
  }
  canvas.text({area.x + 0.5 * area.width, area.bottom() + 24.0},
              "Log-worth (0: mean of these stimuli)",
              {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
}

void draw_line(Canvas& canvas, const WorthChart& chart, const WorthLine& line, const Box& row) {
  const double names = names_width_of(chart);
  const double middle = row.middle();
  canvas.text({row.x, middle + 2.8}, line.name, {.size = 8.0, .max_width = names - 6.0});
  const double axis = row.x + names;
  const auto x = [&](double worth) {
    const double share = (worth - chart.low) / (chart.high - chart.low);
    return axis + std::clamp(share, 0.0, 1.0) * axis_width_of(chart);
  };
  if (std::isnan(line.worth)) {
    const TextStyle style = {.size = 7.5, .colour = quiet_ink};
    canvas.fill(
        Box{axis + 2.0, row.y + 3.0, canvas.text_width(line.note, style) + 4.0, row.height - 6.0},
        paper);
    canvas.text({axis + 4.0, middle + 2.8}, line.note, style);
    return;
  }
  const bool has_ends = std::isfinite(line.ends.low) && std::isfinite(line.ends.high);
  if (has_ends)
    canvas.line({x(line.ends.low), middle}, {x(line.ends.high), middle},
                {.width = 1.4, .colour = created_colours.line});
  canvas.disc({x(line.worth), middle}, 2.8, created_colours.line);
  std::string text = signed_text(line.worth);
  if (has_ends)
    text += fmt::format(" [{}, {}]", signed_text(line.ends.low), signed_text(line.ends.high));
  canvas.text({row.right(), middle + 2.8}, text, {.size = 7.5, .align = Align::right});
  if (!line.note.empty())
    canvas.text({axis + 4.0, middle + 2.8}, line.note, {.size = 6.5, .colour = quiet_ink});
}

Plot worth_plot(const WorthChart& chart) {
  const double names = names_width_of(chart);
  const double width = page_width_of(chart);
  const double rows = worth_row_height * static_cast<double>(chart.lines.size());
  const double height = 2.0 * worth_margin + worth_header + rows + worth_axis_height;
  return {
      chart.title, width, height, [=](Canvas& canvas) {
        canvas.text({worth_margin, worth_margin + 12.0}, chart.title, {.size = 12.0, .bold = true});
        canvas.text({worth_margin, worth_margin + 27.0}, chart.words,
                    {.size = 8.5, .colour = quiet_ink});
        const double top = worth_margin + worth_header;
        draw_axis(canvas, chart, {worth_margin + names, top, axis_width_of(chart), rows + 4.0});
        for (std::size_t i = 0; i < chart.lines.size(); ++i)
          draw_line(canvas, chart, chart.lines[i],
                    {worth_margin, top + worth_row_height * static_cast<double>(i),
                     width - 2.0 * worth_margin, worth_row_height});
      }};
}

/// An axis that has all intervals between two ticks, and 0.
void set_axis(WorthChart& chart) {
  double most = 0.5;
  for (const WorthLine& line : chart.lines)
    for (const double value : {line.worth, line.ends.low, line.ends.high})
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
  for (const double step : {0.25, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    chart.step = step;
    if (most / step <= 5.0) break;
  }
  chart.high = chart.step * std::ceil(most / chart.step);
  chart.low = -chart.high;
}

std::string note_of(const StimulusWorth& one, bool has_groups) {
  if (std::isnan(one.worth)) return record_text(one) + ": no finite worth";
  return has_groups ? fmt::format("group {}", one.group) : "";
}

WorthChart worth_chart(const AnswerSet& answer_set, const PairWorth& worth) {
  WorthChart chart;
  chart.title = (answer_set.factorial.factors.empty() ? "Worth of the stimuli: "
                                                      : "Worth of the conditions: ") +
                pair_question(answer_set, worth.item);
  chart.words = std::string("With 95 % intervals (") +
                (worth.is_by_participants ? "participants resampled"
                                          : "profile likelihood, answers independent") +
                "); a difference of 1: odds of 2.7 to 1 of being chosen";
  std::vector<const StimulusWorth*> sorted;
  int groups = 0;
  for (const StimulusWorth& one : worth.stimuli) {
    sorted.push_back(&one);
    const auto same = [&](const StimulusWorth* other) {
      return !std::isnan(other->worth) && other->group == one.group && other != &one;
    };
    groups += !std::isnan(one.worth) && std::ranges::none_of(sorted, same) ? 1 : 0;
  }
  // Highest worth first; those without worth by their record: above, below.
  const auto rank = [](const StimulusWorth* one) {
    constexpr double beyond = 1e9;
    if (!std::isnan(one->worth)) return one->worth - 1e3 * one->group;
    return one->record == WinRecord::always_won ? beyond : -beyond;
  };
  std::ranges::stable_sort(sorted, std::ranges::greater{}, rank);
  for (const StimulusWorth* one : sorted)
    chart.lines.push_back({one->name, note_of(*one, groups > 1), one->worth, worth.ends_of(*one)});
  set_axis(chart);
  return chart;
}

}  // namespace

void add_worth_figures(const Results& results, std::vector<ResultFigure>& figures) {
  for (const PairWorth& worth : results.worths)
    figures.push_back(
        {"worth-" + worth.item, "worth", "", "",
         "Log-worths of Bradley and Terry’s model with 95 % intervals, highest first.",
         with_simulated_mark(worth_plot(worth_chart(results.answer_set, worth)),
                             results.answer_set.simulated)});
}

}  // namespace mien::pipeline
