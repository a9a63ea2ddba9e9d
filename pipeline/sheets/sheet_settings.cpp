#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pipeline/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

constexpr double heading_height = 24.0;

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "–";
}

void draw_values(Canvas& canvas, const Box& box, double baseline,
                 const std::optional<double>& target, const std::optional<double>& created) {
  const ValueColumns columns = value_columns(box);
  canvas.text({columns.target, baseline}, number(target),
              {.size = 8.0, .colour = target_colours.line, .align = Align::right});
  canvas.text({columns.created, baseline}, number(created),
              {.size = 8.0, .colour = created_colours.line, .align = Align::right});
}

void draw_value_titles(Canvas& canvas, const Box& box) {
  const ValueColumns columns = value_columns(box);
  canvas.text({columns.target, box.y + 10.0}, "target",
              {.size = 8.0, .colour = target_colours.line, .bold = true, .align = Align::right});
  canvas.text({columns.created, box.y + 10.0}, "created",
              {.size = 8.0, .colour = created_colours.line, .bold = true, .align = Align::right});
}

double bars_right(const Box& box) { return value_columns(box).target - 34.0; }

/// A name in English with the Japanese behind it, or before `x` when aligned right.
void draw_both_names(Canvas& canvas, Point baseline, const std::string& english,
                     const std::string& japanese, Align align, double max_width) {
  const std::string both = japanese.empty() ? english : english + " " + japanese;
  canvas.text(baseline, both, {.size = 8.0, .align = align, .max_width = max_width});
}

void draw_slider(Canvas& canvas, const SheetParameter& parameter, const Box& row, double right) {
  const double width = right - row.x;
  const double names = row.y + 8.0;
  const double track = std::min(row.bottom() - 6.0, row.y + 13.0);
  if (parameter.name.empty()) {
    draw_both_names(canvas, {row.x, names}, parameter.low, parameter.japanese_low, Align::left,
                    0.5 * width - 4.0);
    draw_both_names(canvas, {right, names}, parameter.high, parameter.japanese_high, Align::right,
                    0.5 * width - 4.0);
  } else {
    draw_both_names(canvas, {row.x, names}, parameter.name, parameter.japanese, Align::left, width);
  }
  canvas.line({row.x, track}, {right, track}, {.width = 1.2, .colour = hairline});
  for (const double tick : {0.0, 0.5, 1.0}) {
    const double x = row.x + tick * width;
    canvas.line({x, track - 2.0}, {x, track + 2.0}, {.width = 0.8, .colour = hairline});
  }
  const auto at = [&](double value) {
    return Point{row.x + std::clamp(value, 0.0, 1.0) * width, track};
  };
  if (parameter.created) canvas.disc(at(*parameter.created), 4.0, paper);
  if (parameter.target) canvas.disc(at(*parameter.target), 2.6, target_colours.line);
  if (parameter.created) {
    canvas.ring(at(*parameter.created), 4.0, {.width = 1.4, .colour = created_colours.line});
  }
  draw_values(canvas, {row.x, row.y, row.width, row.height}, track + 2.8, parameter.target,
              parameter.created);
}

/// The weights of one example in both blends.
struct WeightPair {
  std::string example;
  double target = 0.0;
  double created = 0.0;

  double most() const { return std::max(target, created); }
};

std::vector<WeightPair> weight_pairs(const SheetContent& content) {
  std::vector<WeightPair> pairs;
  const auto pair_of = [&](const std::string& example) -> WeightPair& {
    const auto found = std::ranges::find(pairs, example, &WeightPair::example);
    return found == pairs.end() ? pairs.emplace_back(WeightPair{example}) : *found;
  };
  for (const auto& [example, weight] : content.target.weights) pair_of(example).target = weight;
  for (const auto& [example, weight] : content.created.weights) pair_of(example).created = weight;
  return pairs;
}

/// At most `rows` pairs, the largest first; the rest as one.
std::vector<WeightPair> largest(std::vector<WeightPair> pairs, std::size_t rows) {
  std::ranges::stable_sort(pairs, std::greater{}, &WeightPair::most);
  if (pairs.size() <= rows) return pairs;
  WeightPair rest{fmt::format("{} others", pairs.size() - rows + 1)};
  for (std::size_t i = rows - 1; i < pairs.size(); ++i) {
    rest.target += pairs[i].target;
    rest.created += pairs[i].created;
  }
  pairs.resize(rows - 1);
  pairs.push_back(rest);
  return pairs;
}

constexpr double weight_row = 11.5;
constexpr double slider_row = 24.0;
constexpr double tightest_slider_row = 20.0;

void draw_weight(Canvas& canvas, const WeightPair& pair, const Box& row, double limit) {
  const double names = 78.0;
  const double start = row.x + names;
  const double width = bars_right(row) - start;
  canvas.text({row.x, row.middle() + 2.9}, pair.example, {.size = 8.0, .max_width = names - 6.0});
  const double thickness = 3.6;
  canvas.fill(Box{start, row.middle() - thickness - 0.3, width * pair.target / limit, thickness},
              target_colours.line);
  canvas.fill(Box{start, row.middle() + 0.3, width * pair.created / limit, thickness},
              created_colours.line);
  draw_values(canvas, row, row.middle() + 2.9, pair.target, pair.created);
}

void draw_remark(Canvas& canvas, const Box& box, double baseline, const std::string& remark) {
  canvas.text({box.x, baseline}, remark,
              {.size = 8.0, .colour = quiet_ink, .max_width = box.width});
}

}  // namespace

ValueColumns value_columns(const Box& box) { return {box.right() - 42.0, box.right()}; }

void draw_parameters(Canvas& canvas, const SheetContent& content, const Box& box) {
  draw_heading(canvas, {box.x, box.y + 10.0}, "Parameters", "指標");
  if (content.parameters.empty()) {
    draw_remark(canvas, box, box.y + heading_height + 6.0, "Neither motion was asked for by name.");
    return;
  }
  draw_value_titles(canvas, box);
  const double space = box.height - heading_height;
  const auto count = content.parameters.size();
  const auto fitting = static_cast<std::size_t>(space / tightest_slider_row);
  const std::size_t shown = count <= fitting ? count : fitting - 1;
  const double height = std::min(slider_row, space / static_cast<double>(std::min(count, fitting)));
  Box row = {box.x, box.y + heading_height - 4.0, box.width, height};
  for (std::size_t i = 0; i < shown; ++i, row.y += height) {
    draw_slider(canvas, content.parameters[i], row, bars_right(box));
  }
  if (shown < count) {
    draw_remark(canvas, box, row.y + 9.0, fmt::format("and {} more", count - shown));
  }
}

void draw_weights(Canvas& canvas, const SheetContent& content, const Box& box) {
  draw_heading(canvas, {box.x, box.y + 10.0}, "Blend weights", "混合比");
  const auto rows = static_cast<std::size_t>((box.height - heading_height + 6.0) / weight_row);
  const std::vector<WeightPair> pairs = largest(weight_pairs(content), rows);
  if (pairs.empty()) {
    draw_remark(canvas, box, box.y + heading_height + 6.0, "Neither motion is a blend.");
    return;
  }
  draw_value_titles(canvas, box);
  double most = 0.0;
  for (const WeightPair& pair : pairs) most = std::max(most, pair.most());
  const double limit = std::max(0.2, std::ceil(5.0 * most - 1e-9) / 5.0);
  Box row = {box.x, box.y + heading_height - 6.0, box.width, weight_row};
  for (const WeightPair& pair : pairs) {
    draw_weight(canvas, pair, row, limit);
    row.y += weight_row;
  }
}

void draw_settings(Canvas& canvas, const SheetContent& content, const Box& box) {
  // Parameters first: what was asked for matters more than how it was made. Six rows of weights are
  // kept free for them to be of use.
  const double gap = 10.0;
  const auto weights = std::min<std::size_t>(6, weight_pairs(content).size());
  const double kept =
      heading_height + weight_row * static_cast<double>(std::max<std::size_t>(1, weights));
  const double wanted = heading_height + slider_row * static_cast<double>(std::max<std::size_t>(
                                                          1, content.parameters.size()));
  const double height = std::min(wanted, box.height - gap - kept);
  draw_parameters(canvas, content, {box.x, box.y, box.width, height});
  const double top = box.y + height + gap;
  draw_weights(canvas, content, {box.x, top, box.width, box.bottom() - top});
}

}  // namespace mien::pipeline
