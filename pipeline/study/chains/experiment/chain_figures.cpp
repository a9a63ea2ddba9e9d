#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/chains/experiment/chain_figure_parts.h"

namespace mien::pipeline {

namespace {

std::string range_text(const DimensionRange& range) {
  return fmt::format("{:.2f}–{:.2f}", range.low, range.high);
}

// Traces of chains.

constexpr double panel_width = 120.0;
constexpr double panel_height = 56.0;
constexpr double panel_gap = 12.0;

void draw_panel(Canvas& canvas, const ChainResults& results, const std::string& word,
                std::size_t dimension, double sweeps, const Box& box) {
  const DimensionRange& range = results.design.space[dimension];
  canvas.fill(box, panel);
  const std::size_t every = results.design.steps_per_sweep();
  const int unused = results.of(word).discarded;
  for (const ChainPath& path : results.paths) {
    if (path.name.word != word) continue;
    std::vector<Point> used, discarded;
    for (std::size_t step = every - 1; step < path.points.size(); step += every) {
      const std::size_t sweep = step / every;
      const Point at = {box.x + box.width * (static_cast<double>(sweep) + 0.5) / sweeps,
                        box.bottom() - box.height * share_of(range, path.points[step][dimension])};
      const bool is_used = static_cast<int>(sweep) >= unused;
      // The line goes on from what is discarded.
      if (!is_used || used.empty()) discarded.push_back(at);
      if (is_used) used.push_back(at);
    }
    if (discarded.size() > 1) canvas.polyline(discarded, {.width = 0.6, .colour = hairline});
    if (used.size() > 1) canvas.polyline(used, {.width = 0.7, .colour = created_colours.line});
    if (used.size() == 1) canvas.disc(used.front(), 1.2, created_colours.line);
  }
}

/// At least 1.
double longest_sweeps(const ChainResults& results) {
  std::size_t longest = 1;
  for (const ChainPath& path : results.paths)
    longest = std::max(longest, path.points.size() / results.design.steps_per_sweep());
  return static_cast<double>(longest);
}

std::string chains_subtitle(const ChainResults& results) {
  const int unused = results.words.front().discarded;
  const bool are_equal = std::ranges::all_of(
      results.words, [&](const WordSamples& word) { return word.discarded == unused; });
  std::string text =
      results.design.method == ChainMethod::gibbs ? "Points by sweep" : "Points by choice";
  if (!are_equal) return text + "; grey: not used";
  if (unused > 0) text += fmt::format("; grey: the first {}, which are not used", unused);
  return text;
}

// Samples and prototypes.

constexpr double line_height = 16.0;
constexpr double axis_width = 320.0;
constexpr double values_width = 120.0;

void draw_word(Canvas& canvas, const WordSamples& word, std::size_t d, const DimensionRange& range,
               const Box& row) {
  const DimensionSamples& samples = word.dimensions[d];
  const double axis = row.x + names_width;
  const auto x = [&](double value) { return axis + axis_width * share_of(range, value); };
  canvas.text({row.x + 8.0, row.middle() + 2.8}, word.word,
              {.size = 8.0, .max_width = names_width - 12.0});
  canvas.line({axis, row.middle()}, {axis + axis_width, row.middle()},
              {.width = 0.4, .colour = hairline});
  for (const std::vector<double>& chain : samples.values)
    for (const double value : chain)
      canvas.line({x(value), row.middle() - 4.0}, {x(value), row.middle() + 4.0},
                  {.width = 0.5, .colour = created_colours.light});
  const auto& [low, high] = samples.mean.ends;
  const bool has_ends = std::isfinite(low) && std::isfinite(high);
  if (has_ends)
    canvas.line({x(low), row.middle()}, {x(high), row.middle()},
                {.width = 2.0, .colour = created_colours.line});
  canvas.disc({x(samples.mean.mean), row.middle()}, 2.8, created_colours.line);
  std::string text = fmt::format("{:.2f}", samples.mean.mean);
  if (has_ends) text += fmt::format(" [{:.2f}, {:.2f}]", low, high);
  canvas.text({row.right(), row.middle() + 2.8}, text, {.size = 7.5, .align = Align::right});
}

}  // namespace

Plot chains_plot(const ChainResults& results) {
  const auto dimensions = static_cast<double>(results.design.dimensions.size());
  const auto words = static_cast<double>(results.words.size());
  const double width =
      std::max(2.0 * figure_margin + names_width + dimensions * (panel_width + panel_gap), 420.0);
  const double height =
      2.0 * figure_margin + figure_header + 16.0 + words * (panel_height + panel_gap) + 14.0;
  const double sweeps = longest_sweeps(results);
  return {"Chains", width, height, [&results, width, sweeps](Canvas& canvas) {
            draw_figure_header(canvas, results, "Chains", chains_subtitle(results), width);
            const double top = figure_margin + figure_header + 16.0;
            for (std::size_t d = 0; d < results.design.dimensions.size(); ++d) {
              const double x =
                  figure_margin + names_width + static_cast<double>(d) * (panel_width + panel_gap);
              canvas.text({x, top - 6.0}, results.design.dimensions[d],
                          {.size = 8.0, .bold = true, .max_width = panel_width - 44.0});
              canvas.text({x + panel_width, top - 6.0}, range_text(results.design.space[d]),
                          {.size = 7.0, .colour = quiet_ink, .align = Align::right});
              for (std::size_t w = 0; w < results.words.size(); ++w) {
                const double y = top + static_cast<double>(w) * (panel_height + panel_gap);
                if (d == 0)
                  canvas.text({figure_margin, y + 0.5 * panel_height + 3.0}, results.words[w].word,
                              {.size = 9.0, .bold = true, .max_width = names_width - 8.0});
                draw_panel(canvas, results, results.words[w].word, d, sweeps,
                           {x, y, panel_width, panel_height});
              }
            }
          }};
}

Plot prototypes_plot(const ChainResults& results) {
  const auto words = static_cast<double>(results.words.size());
  const double group = 20.0 + words * line_height + 8.0;
  const double width = 2.0 * figure_margin + names_width + axis_width + values_width;
  const double height = 2.0 * figure_margin + figure_header +
                        static_cast<double>(results.design.dimensions.size()) * group + 6.0;
  return {"Prototypes", width, height, [&results, group, width](Canvas& canvas) {
            draw_figure_header(canvas, results, "Prototypes",
                               "Means of the samples with 95 % intervals; ticks: samples", width);
            for (std::size_t d = 0; d < results.design.dimensions.size(); ++d) {
              const DimensionRange& range = results.design.space[d];
              const double top = figure_margin + figure_header + static_cast<double>(d) * group;
              canvas.text({figure_margin, top + 12.0}, results.design.dimensions[d],
                          {.size = 8.5, .bold = true});
              const double axis = figure_margin + names_width;
              canvas.text({axis, top + 12.0}, fmt::format("{:.2f}", range.low),
                          {.size = 7.0, .colour = quiet_ink, .align = Align::centre});
              canvas.text({axis + axis_width, top + 12.0}, fmt::format("{:.2f}", range.high),
                          {.size = 7.0, .colour = quiet_ink, .align = Align::centre});
              for (std::size_t w = 0; w < results.words.size(); ++w)
                draw_word(canvas, results.words[w], d, range,
                          {figure_margin, top + 18.0 + static_cast<double>(w) * line_height,
                           width - 2.0 * figure_margin, line_height});
            }
          }};
}

}  // namespace mien::pipeline
