#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "motion/skeleton/clip.h"
#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

using motion::BodyJoint;
using motion::Vec3;

constexpr int samples = 101;
constexpr int shown_joints = 3;
constexpr std::array<const char*, 3> axis_names = {"left", "up", "forward"};
constexpr std::array<int, 3> axis_order = {2, 1, 0};

/// A joint's path over the normalised duration of both motions.
struct JointCurves {
  BodyJoint joint;
  std::array<Vec3, samples> target;
  std::array<Vec3, samples> created;
};

std::vector<BodyJoint> worst_joints(const motion::Distance& distance) {
  std::array<int, motion::distance_joints> order;
  std::iota(order.begin(), order.end(), 1);
  const auto means = distance.by_joint();
  std::ranges::stable_sort(order, std::greater{},
                           [&](int j) { return means[static_cast<std::size_t>(j - 1)]; });
  std::vector<BodyJoint> worst;
  for (std::size_t i = 0; i < shown_joints; ++i) worst.push_back(BodyJoint(order[i]));
  return worst;
}

std::vector<JointCurves> curves_of(const SheetContent& content) {
  std::vector<JointCurves> curves;
  for (const BodyJoint joint : worst_joints(content.distance)) curves.push_back({joint, {}, {}});
  const auto positions = [&](const motion::Example& moving, double share) {
    const double seconds = motion::corresponding_time(content.target.motion, moving, share);
    return motion::world_positions(
        moving.clip.body,
        motion::aligned_pose_at(moving.clip, seconds, content.distance.alignment));
  };
  for (std::size_t i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / (samples - 1);
    const auto target = positions(content.target.motion, share);
    const auto created = positions(content.created.motion, share);
    for (JointCurves& c : curves) {
      c.target[i] = target[static_cast<std::size_t>(c.joint)];
      c.created[i] = created[static_cast<std::size_t>(c.joint)];
    }
  }
  return curves;
}

struct Range {
  double least;
  double most;
};

Range range_of(const JointCurves& curves, int axis) {
  Range range = {curves.target[0][axis], curves.target[0][axis]};
  for (const auto* path : {&curves.target, &curves.created}) {
    for (const Vec3& p : *path) {
      range.least = std::min(range.least, p[axis]);
      range.most = std::max(range.most, p[axis]);
    }
  }
  return range;
}

/// Metres that a joint's plots span: as many as the coordinate that moves most, and some air.
double common_span(const JointCurves& curves) {
  double span = 0.1;
  for (const int axis : axis_order) {
    const Range range = range_of(curves, axis);
    span = std::max(span, range.most - range.least);
  }
  return 1.12 * span;
}

/// 1, 2 or 5 times a power of ten: at least two ticks in the span.
double tick_step(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span / 2.0)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= span / 2.0) return factor * decade;
  }
  return decade;
}

/// One coordinate of one joint.
struct Plot {
  Box box;
  double bottom_metres;
  double span_metres;

  Point at(double share, double metres) const {
    return {box.x + share * box.width,
            box.bottom() - (metres - bottom_metres) / span_metres * box.height};
  }
};

void draw_frame(Canvas& canvas, const Plot& plot) {
  canvas.fill(plot.box, panel);
  const double step = tick_step(plot.span_metres);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double tick = std::ceil(plot.bottom_metres / step) * step;
       tick <= plot.bottom_metres + plot.span_metres; tick += step) {
    const Point left = plot.at(0.0, tick);
    canvas.line(left, plot.at(1.0, tick), {.width = 0.6, .colour = hairline});
    // Too near an edge a number would run into the plot's title or the times below.
    const double clear = 3.0;
    if (left.y < plot.box.y + clear || left.y > plot.box.bottom() - clear) continue;
    const double shown = std::abs(tick) < 0.5 * step ? 0.0 : tick;
    canvas.text({left.x - 3.0, left.y + 2.6}, fmt::format("{:.{}f}", shown, decimals),
                {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  }
}

void draw_plot(Canvas& canvas, const JointCurves& curves, int axis, const Plot& plot) {
  draw_frame(canvas, plot);
  std::vector<Point> target;
  std::vector<Point> created;
  for (std::size_t i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / (samples - 1);
    target.push_back(plot.at(share, curves.target[i][axis]));
    created.push_back(plot.at(share, curves.created[i][axis]));
  }
  std::vector<Point> between = target;
  between.insert(between.end(), created.rbegin(), created.rend());
  canvas.fill(between, quiet_ink, 0.18);
  canvas.polyline(target, {.width = 2.0, .colour = target_colours.line});
  canvas.polyline(created, {.width = 1.1, .colour = created_colours.line});
  canvas.text({plot.box.x, plot.box.y - 3.5}, axis_names[static_cast<std::size_t>(axis)],
              {.size = 8.0, .colour = quiet_ink});
  const double below = plot.box.bottom() + 9.0;
  canvas.text({plot.box.x, below}, "0", {.size = 7.0, .colour = quiet_ink});
  canvas.text({plot.box.right(), below}, "100 %",
              {.size = 7.0, .colour = quiet_ink, .align = Align::right});
}

void draw_joint(Canvas& canvas, const JointCurves& curves, double mean, NameLanguage names,
                const Box& box) {
  const Box name = canvas.text({box.x, box.y + 24.0},
                               name_in(names, spoken_name(curves.joint),
                                       std::string(motion::japanese_name_of(curves.joint))),
                               {.size = 9.0, .bold = true});
  canvas.text({name.right() + 5.0, box.y + 24.0}, fmt::format("{:.3f} m", mean),
              {.size = 8.0, .colour = quiet_ink});
  const double span = common_span(curves);
  const double labels = 24.0;
  const double width = box.width / 3.0;
  for (std::size_t i = 0; i < axis_order.size(); ++i) {
    const Range range = range_of(curves, axis_order[i]);
    const double middle = 0.5 * (range.least + range.most);
    const Box plot = {box.x + static_cast<double>(i) * width + labels, box.y + 40.0,
                      width - labels - 6.0, box.height - 40.0 - 11.0};
    draw_plot(canvas, curves, axis_order[i], {plot, middle - 0.5 * span, span});
  }
}

}  // namespace

void draw_curves(Canvas& canvas, const SheetContent& content, const Box& box) {
  draw_heading(canvas, {box.x, box.y + 9.0}, "The three joints with the largest differences",
               "position over time in metres, one scale per joint; thick: target, thin: created");
  const std::vector<JointCurves> curves = curves_of(content);
  const auto means = content.distance.by_joint();
  const double gap = 22.0;
  const double width = (box.width - 2.0 * gap) / shown_joints;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    draw_joint(canvas, curves[i], means[static_cast<std::size_t>(curves[i].joint - 1)],
               content.names,
               {box.x + static_cast<double>(i) * (width + gap), box.y, width, box.height});
  }
}

}  // namespace mien::pipeline
