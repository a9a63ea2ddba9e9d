#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

constexpr double heading_height = 24.0;

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "–";
}

TextStyle number_style(Colour colour, bool is_bold) {
  return {.size = 8.0, .colour = colour, .bold = is_bold, .align = Align::right};
}

constexpr TextStyle column_head = {.size = 6.5, .colour = quiet_ink, .align = Align::right};

/// "0.70" for a requested value, "held 0.50" for a held one.
std::string requested_text(const SheetValue& value) {
  if (value.requested) return number(value.requested);
  return value.held ? "held " + number(value.held) : "";
}

/// The columns of one motion in a table of parameters.
struct MotionColumns {
  double left = 0.0;                ///< left edge of all
  std::optional<double> requested;  ///< right edge; none if nothing is requested or held
  double reached = 0.0;             ///< right edge
};

struct ParameterColumns {
  double sliders = 0.0;  ///< right edge of names and sliders
  MotionColumns target, created;
};

/// Columns as wide as their heads and values, the last one ending at `right`.
MotionColumns motion_columns(const Canvas& canvas, double right, const char* title,
                             const std::vector<SheetParameter>& parameters,
                             SheetValue SheetParameter::*motion) {
  constexpr double gap = 5.0;
  MotionColumns columns;
  columns.reached = right;
  columns.left = right - std::max(canvas.text_width("reached", column_head),
                                  canvas.text_width(title, number_style(ink, true)));
  double width = 0.0;
  for (const SheetParameter& parameter : parameters)
    width = std::max(width, canvas.text_width(requested_text(parameter.*motion),
                                              number_style(quiet_ink, false)));
  if (width == 0.0) return columns;
  columns.requested = columns.left - gap;
  columns.left = *columns.requested - std::max(width, canvas.text_width("requested", column_head));
  return columns;
}

ParameterColumns parameter_columns(const Canvas& canvas, const Box& box,
                                   const std::vector<SheetParameter>& parameters) {
  constexpr double gap = 8.0;
  ParameterColumns columns;
  columns.created =
      motion_columns(canvas, box.right(), "created", parameters, &SheetParameter::created);
  columns.target = motion_columns(canvas, columns.created.left - gap, "target", parameters,
                                  &SheetParameter::target);
  columns.sliders = columns.target.left - gap;
  return columns;
}

void draw_values(Canvas& canvas, const Box& box, double baseline,
                 const std::optional<double>& target, const std::optional<double>& created) {
  const ValueColumns columns = value_columns(box);
  canvas.text({columns.target, baseline}, number(target), number_style(target_colours.line, false));
  canvas.text({columns.created, baseline}, number(created),
              number_style(created_colours.line, false));
}

void draw_value_titles(Canvas& canvas, const Box& box) {
  const ValueColumns columns = value_columns(box);
  canvas.text({columns.target, box.y + 10.0}, "target", number_style(target_colours.line, true));
  canvas.text({columns.created, box.y + 10.0}, "created", number_style(created_colours.line, true));
}

void draw_parameter_titles(Canvas& canvas, const Box& box, const ParameterColumns& columns) {
  const auto draw = [&](const MotionColumns& motion, const char* title, const Colour& colour) {
    canvas.text({motion.reached, box.y + 4.0}, title, number_style(colour, true));
    if (motion.requested) canvas.text({*motion.requested, box.y + 12.0}, "requested", column_head);
    canvas.text({motion.reached, box.y + 12.0}, "reached", column_head);
  };
  draw(columns.target, "target", target_colours.line);
  draw(columns.created, "created", created_colours.line);
}

/// Requested values in grey, reached ones in the motion's colour.
void draw_requested_and_reached(Canvas& canvas, const ParameterColumns& columns, double baseline,
                                const SheetParameter& parameter) {
  const auto draw = [&](const MotionColumns& motion, const SheetValue& value,
                        const Colour& colour) {
    const std::string requested = requested_text(value);
    if (!requested.empty())
      canvas.text({motion.requested.value(), baseline}, requested, number_style(quiet_ink, false));
    canvas.text({motion.reached, baseline}, number(value.reached),
                number_style(colour, value.requested.has_value()));
  };
  draw(columns.target, parameter.target, target_colours.line);
  draw(columns.created, parameter.created, created_colours.line);
}

double bars_right(const Box& box) { return value_columns(box).target - 34.0; }

void draw_name(Canvas& canvas, Point baseline, const std::string& name, Align align,
               double max_width) {
  canvas.text(baseline, name, {.size = 8.0, .align = align, .max_width = max_width});
}

void draw_names(Canvas& canvas, const SheetParameter& parameter, NameLanguage names, double left,
                double right, double baseline) {
  if (!parameter.name.empty())
    return draw_name(canvas, {left, baseline}, name_in(names, parameter.name, parameter.japanese),
                     Align::left, right - left);
  const double half = 0.5 * (right - left) - 4.0;
  draw_name(canvas, {left, baseline}, name_in(names, parameter.low, parameter.japanese_low),
            Align::left, half);
  draw_name(canvas, {right, baseline}, name_in(names, parameter.high, parameter.japanese_high),
            Align::right, half);
}

/// Discs where the motions are, short strokes across the track at the requested values.
void draw_slider(Canvas& canvas, const SheetParameter& parameter, NameLanguage names,
                 const Box& row, const ParameterColumns& columns) {
  const double right = columns.sliders;
  const double track = std::min(row.bottom() - 6.0, row.y + 13.0);
  draw_names(canvas, parameter, names, row.x, right, row.y + 8.0);
  canvas.line({row.x, track}, {right, track}, {.width = 1.2, .colour = hairline});
  const auto at = [&](double value) {
    return Point{row.x + std::clamp(value, 0.0, 1.0) * (right - row.x), track};
  };
  for (const double tick : {0.0, 0.5, 1.0}) {
    canvas.line({at(tick).x, track - 2.0}, {at(tick).x, track + 2.0},
                {.width = 0.8, .colour = hairline});
  }
  const auto stroke = [&](const std::optional<double>& requested, Colour colour) {
    if (!requested) return;
    canvas.line({at(*requested).x, track - 5.0}, {at(*requested).x, track + 5.0},
                {.width = 1.1, .colour = colour});
  };
  const std::optional<double>& created = parameter.created.reached;
  if (created) canvas.disc(at(*created), 4.0, paper);
  stroke(parameter.target.requested, target_colours.line);
  stroke(parameter.created.requested, created_colours.line);
  if (parameter.target.reached)
    canvas.disc(at(*parameter.target.reached), 2.6, target_colours.line);
  if (created) canvas.ring(at(*created), 4.0, {.width = 1.4, .colour = created_colours.line});
  draw_requested_and_reached(canvas, columns, track + 2.8, parameter);
}

/// A parameter that neither motion requests, in one line.
void draw_plain_parameter(Canvas& canvas, const SheetParameter& parameter, NameLanguage names,
                          const Box& row, const ParameterColumns& columns) {
  draw_names(canvas, parameter, names, row.x, columns.sliders, row.y + 8.0);
  draw_requested_and_reached(canvas, columns, row.y + 8.0, parameter);
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
constexpr double slider_row = 21.0;
constexpr double plain_row = 10.5;

/// The height of all parameters with their heading, in points.
double wanted_height(const std::vector<SheetParameter>& parameters) {
  double height = heading_height;
  for (const SheetParameter& parameter : parameters)
    height += parameter.is_requested() ? slider_row : plain_row;
  return parameters.empty() ? height + slider_row : height;
}

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
  draw_heading(canvas, {box.x, box.y + 10.0}, name_in(content.names, "Parameters", "指標"));
  if (content.parameters.empty()) {
    draw_remark(canvas, box, box.y + heading_height + 6.0,
                "Neither motion has requested parameters.");
    return;
  }
  const ParameterColumns columns = parameter_columns(canvas, box, content.parameters);
  draw_parameter_titles(canvas, box, columns);
  Box row = {box.x, box.y + heading_height - 6.0, box.width, 0.0};
  for (std::size_t i = 0; i < content.parameters.size(); ++i, row.y += row.height) {
    const SheetParameter& parameter = content.parameters[i];
    row.height = parameter.is_requested() ? slider_row : plain_row;
    const bool is_last = i + 1 == content.parameters.size();
    if (row.bottom() + (is_last ? 0.0 : plain_row) > box.bottom() + 0.1) {
      const std::size_t left_out = content.parameters.size() - i;
      draw_remark(canvas, box, row.y + 8.0,
                  fmt::format("and {} more in metrics/parameters.csv", left_out));
      return;
    }
    if (parameter.is_requested()) {
      draw_slider(canvas, parameter, content.names, row, columns);
    } else {
      draw_plain_parameter(canvas, parameter, content.names, row, columns);
    }
  }
}

void draw_weights(Canvas& canvas, const SheetContent& content, const Box& box) {
  draw_heading(canvas, {box.x, box.y + 10.0}, name_in(content.names, "Blend weights", "混合比"));
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
  // Parameters first: what was requested matters more than how it was made. Six rows of weights are
  // kept free for them to be of use.
  const double gap = 10.0;
  const auto weights = std::min<std::size_t>(6, weight_pairs(content).size());
  const double kept =
      heading_height + weight_row * static_cast<double>(std::max<std::size_t>(1, weights));
  const double wanted = wanted_height(content.parameters);
  const double height = std::min(wanted, box.height - gap - kept);
  draw_parameters(canvas, content, {box.x, box.y, box.width, height});
  const double top = box.y + height + gap;
  draw_weights(canvas, content, {box.x, top, box.width, box.bottom() - top});
}

}  // namespace mien::pipeline
