#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/clip.h"
#include "pipeline/sheet_parts.h"

namespace mien::pipeline {

namespace {

using motion::Vec3;

/// A point of a figure as the sheet's camera sees it, metres: right, up and away.
struct Seen {
  double right;
  double up;
  double away;
};

/// Orthographic, level, from the figure's right and a little ahead of it: who walks forward walks
/// to the right of the page.
Seen seen(const Vec3& p) {
  const double turn = 25.0 * motion::radians_per_degree;
  return {p.x() * std::sin(turn) + p.z() * std::cos(turn), p.y(),
          p.x() * std::cos(turn) - p.z() * std::sin(turn)};
}

/// Bones in a row that are drawn in one stroke, or the head.
struct Limb {
  std::vector<Seen> joints;
  double width;  ///< metres
  bool left = false;
  bool head = false;

  double away() const {
    double sum = 0.0;
    for (const Seen& p : joints) sum += p.away;
    return sum / static_cast<double>(joints.size());
  }
};

using Figure = std::vector<Limb>;

/// The joints that a limb runs through; its first bone joins it to the trunk.
struct LimbJoints {
  std::vector<motion::BodyJoint> joints;
  double width;
};

std::vector<LimbJoints> limbs_of_the_body() {
  using namespace motion;
  return {{{Pelvis, Spine, Chest, Neck, Head}, 0.065},
          {{Chest, LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}, 0.045},
          {{Chest, RightClavicle, RightShoulder, RightElbow, RightWrist}, 0.045},
          {{Pelvis, LeftHip, LeftKnee, LeftAnkle, LeftToe}, 0.055},
          {{Pelvis, RightHip, RightKnee, RightAnkle, RightToe}, 0.055}};
}

Figure figure_of(const motion::Skeleton& body, const motion::Pose& pose) {
  const motion::JointTransforms world = motion::world_transforms(body, pose);
  const auto tip_of = [&](std::size_t j) {
    const Vec3 tip = body.joints[j].tip.value_or(Vec3::Zero());
    return seen(world.positions[j] + world.rotations[j] * tip);
  };
  Figure figure;
  for (const auto& [joints, width] : limbs_of_the_body()) {
    Limb limb{{}, width, motion::is_left(joints.back())};
    for (const motion::BodyJoint j : joints) limb.joints.push_back(seen(world.positions[j]));
    if (joints.back() != motion::Head) limb.joints.push_back(tip_of(joints.back()));
    figure.push_back(std::move(limb));
  }
  figure.push_back({{seen(world.positions[motion::Head]), tip_of(motion::Head)}, 0.2, false, true});
  std::ranges::stable_sort(figure, std::greater{}, &Limb::away);  // painter's order
  return figure;
}

/// A motion's figures at the eleven times.
struct FigureRow {
  std::string title;
  std::string japanese;
  std::vector<std::string> remarks;
  Colour title_colour = ink;
  struct Layer {
    std::vector<Figure> figures;
    MotionColours colours;
    double thickness = 1.0;  ///< relative
    bool halo = true;        ///< a rim of paper where one limb passes in front of another
  };
  std::vector<Layer> layers;
};

FigureRow::Layer layer_of(const SheetContent& content, const SheetMotion& shown,
                          const MotionColours& colours, double thickness = 1.0, bool halo = true) {
  FigureRow::Layer layer{{}, colours, thickness, halo};
  for (int t = 0; t < motion::distance_times; ++t) {
    const double seconds = motion::corresponding_time(content.target.motion, shown.motion,
                                                      t / (motion::distance_times - 1.0));
    // Each in its column, whatever the distance was aligned by: travel would leave the page.
    layer.figures.push_back(
        figure_of(shown.motion.clip.body,
                  motion::aligned_pose_at(shown.motion.clip, seconds, motion::Alignment::pelvis)));
  }
  return layer;
}

FigureRow row_of(const SheetContent& content, const SheetMotion& shown, std::string title,
                 std::string japanese, const MotionColours& colours) {
  return {
      std::move(title),
      std::move(japanese),
      {shown.id, fmt::format("{:.2f} s, {}", shown.motion.clip.duration_seconds(), shown.origin)},
      colours.line,
      {layer_of(content, shown, colours)}};
}

std::vector<FigureRow> rows_of(const SheetContent& content) {
  std::vector<FigureRow> rows;
  if (content.reference) {
    rows.push_back(row_of(content, *content.reference, "Reference", "参照", reference_colours));
  }
  rows.push_back(row_of(content, content.target, "Target", "目標", target_colours));
  rows.push_back(row_of(content, content.created, "Created", "作成", created_colours));
  rows.push_back({"Overlay",
                  "重ね合わせ",
                  {"target broad, created fine", "lighter limbs: left"},
                  ink,
                  {layer_of(content, content.target, target_pale, 1.7),
                   layer_of(content, content.created, created_colours, 0.6, false)}});
  return rows;
}

/// What all figures cover, metres.
struct Extent {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double top = 1.0;

  void include(const Limb& limb) {
    for (const Seen& p : limb.joints) {
      left = std::min(left, p.right);
      right = std::max(right, p.right);
      bottom = std::min(bottom, p.up);
      top = std::max(top, p.up);
    }
  }
};

Extent extent_of(const std::vector<FigureRow>& rows) {
  Extent extent;
  for (const FigureRow& row : rows) {
    for (const auto& layer : row.layers) {
      for (const Figure& figure : layer.figures) {
        for (const Limb& limb : figure) extent.include(limb);
      }
    }
  }
  return extent;
}

/// From metres to the page.
struct Scale {
  double points_per_metre;
  Point origin;  ///< below the pelvis, on the floor

  Point at(const Seen& p) const {
    return {origin.x + points_per_metre * p.right, origin.y - points_per_metre * p.up};
  }
};

void draw_head(Canvas& canvas, const Limb& limb, const FigureRow::Layer& layer,
               const Scale& scale) {
  const Point neck = scale.at(limb.joints.front());
  const Point crown = scale.at(limb.joints.back());
  canvas.disc({0.5 * (neck.x + crown.x), 0.5 * (neck.y + crown.y)},
              (0.07 + 0.025 * layer.thickness) * scale.points_per_metre, layer.colours.line);
}

void draw_limb(Canvas& canvas, const Limb& limb, const FigureRow::Layer& layer,
               const Scale& scale) {
  std::vector<Point> points;
  for (const Seen& p : limb.joints) points.push_back(scale.at(p));
  const double width = std::max(0.9, limb.width * scale.points_per_metre) * layer.thickness;
  if (layer.halo) {
    // Not round the first bone, where the limb grows out of the trunk.
    canvas.polyline(std::span(points).subspan(1), {.width = width + 1.1, .colour = paper});
  }
  canvas.polyline(points,
                  {.width = width, .colour = limb.left ? layer.colours.light : layer.colours.line});
}

void draw_figure(Canvas& canvas, const Figure& figure, const FigureRow::Layer& layer,
                 const Scale& scale) {
  for (const Limb& limb : figure) {
    if (limb.head) {
      draw_head(canvas, limb, layer, scale);
    } else {
      draw_limb(canvas, limb, layer, scale);
    }
  }
}

void draw_row_title(Canvas& canvas, const FigureRow& row, const Box& box) {
  const double middle = box.y + 0.5 * box.height;
  const Box title = canvas.text({box.x, middle - 8.0}, row.title,
                                {.size = 11.0, .colour = row.title_colour, .bold = true});
  canvas.text({title.right() + 5.0, middle - 8.0}, row.japanese,
              {.size = 9.0, .colour = row.title_colour});
  double baseline = middle + 5.0;
  for (const std::string& remark : row.remarks) {
    canvas.text({box.x, baseline}, remark,
                {.size = 8.0, .colour = quiet_ink, .max_width = name_width - 6.0});
    baseline += 11.0;
  }
}

}  // namespace

void draw_figures(Canvas& canvas, const SheetContent& content, const Box& box) {
  constexpr double heading = 16.0;
  const std::vector<FigureRow> rows = rows_of(content);
  const Extent extent = extent_of(rows);
  const double row_height = (box.height - heading) / static_cast<double>(rows.size());
  const double column_width = time_column(box, 0).width;
  const double scale = std::min((column_width - 8.0) / (extent.right - extent.left),
                                (row_height - 14.0) / (extent.top - extent.bottom));

  canvas.text({box.x, box.y + 9.0}, "Share of the duration",
              {.size = 8.0, .colour = quiet_ink, .max_width = name_width - 6.0});
  for (int t = 0; t < motion::distance_times; ++t) {
    const Box column = time_column(box, t);
    canvas.text({column.x + 0.5 * column.width, box.y + 9.0}, fmt::format("{} %", 10 * t),
                {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Box row = {box.x, box.y + heading + static_cast<double>(r) * row_height, box.width,
                     row_height};
    const double ground = row.bottom() - 7.0 + scale * extent.bottom;
    canvas.line({time_column(box, 0).x, ground}, {box.right(), ground},
                {.width = 0.7, .colour = hairline});
    draw_row_title(canvas, rows[r], row);
    for (int t = 0; t < motion::distance_times; ++t) {
      const Box column = time_column(box, t);
      const double pelvis =
          column.x + 0.5 * column.width - 0.5 * scale * (extent.left + extent.right);
      for (const auto& layer : rows[r].layers) {
        draw_figure(canvas, layer.figures[static_cast<std::size_t>(t)], layer,
                    {scale, {pelvis, ground}});
      }
    }
  }
}

}  // namespace mien::pipeline
