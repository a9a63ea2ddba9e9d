#include "pipeline/study/adaptive/film_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/base/drawing/point_labels.h"
#include "pipeline/study/adaptive/film_plane.h"
#include "pipeline/study/adaptive/film_report.h"

namespace mien::pipeline {

namespace {

constexpr double map_margin = 20.0;
constexpr double map_header = 46.0;
constexpr std::size_t map_columns = 4;
constexpr double small_width = 152.0;
constexpr double small_height = 112.0;
constexpr double column_gap = 16.0;
constexpr double map_width =
    2.0 * map_margin + map_columns * small_width + (map_columns - 1) * column_gap;
constexpr Box key_box = {map_margin, map_margin + map_header + 14.0, 390.0, 280.0};
constexpr double bands_top = key_box.y + key_box.height + 40.0;
constexpr double bar_room = 24.0;      ///< for the colour bar under a small panel
constexpr double heading_room = 14.0;  ///< for the words above a small panel
constexpr double band_height = 2.0 * (heading_room + small_height + bar_room) + 16.0;
constexpr double mark_radius = 2.6;
constexpr Colour map_panel = from_hex(0xe7ebef);  ///< on which the lightest values are seen
constexpr TextStyle label_style = {.size = 6.5};
constexpr TextStyle map_note = {.size = 7.0, .colour = quiet_ink};

/// What all panels show.
struct MapContent {
  const FilmChoice& choice;
  FilmPlane plane;
  std::vector<Point> candidates;  ///< in the plane
  std::vector<std::pair<std::string, Point>> rated, chosen;

  const std::vector<RatedFilms>& scales() const { return choice.rated.scales; }
};

std::vector<Point> points_in(const FilmPlane& plane, const Eigen::MatrixXd& places) {
  const Eigen::MatrixX2d at = plane.at(places);
  std::vector<Point> points;
  for (Eigen::Index i = 0; i < at.rows(); ++i) points.push_back({at(i, 0), at(i, 1)});
  return points;
}

MapContent content_of(const FilmChoice& choice) {
  MapContent content{choice, film_plane(choice.candidates), {}, {}, {}};
  Eigen::MatrixXd places(static_cast<Eigen::Index>(choice.candidates.size()),
                         choice.candidates.front().place.size());
  for (std::size_t c = 0; c < choice.candidates.size(); ++c)
    places.row(static_cast<Eigen::Index>(c)) = choice.candidates[c].place;
  content.candidates = points_in(content.plane, places);
  std::map<std::string, Point> rated;
  for (const RatedFilms& scale : choice.rated.scales) {
    const std::vector<Point> points = points_in(content.plane, scale.places);
    for (std::size_t f = 0; f < points.size(); ++f)
      rated.emplace(f < scale.ids.size() ? scale.ids[f] : std::string(), points[f]);
  }
  content.rated.assign(rated.begin(), rated.end());
  for (std::size_t f = 0; f < choice.next.films.size(); ++f)
    content.chosen.emplace_back(choice.ids[f], content.candidates[choice.next.films[f].candidate]);
  return content;
}

/// From the plane to a panel, with the same scale in both directions.
class PlaneScale {
 public:
  PlaneScale(const MapContent& content, const Box& box) {
    constexpr double inset = 7.0;
    Point low{1e300, 1e300}, high{-1e300, -1e300};
    const auto include = [&](const Point& point) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    };
    for (const Point& point : content.candidates) include(point);
    for (const auto& [name, point] : content.rated) include(point);
    const double wide = std::max(high.x - low.x, 1e-9), tall = std::max(high.y - low.y, 1e-9);
    per_unit_ = std::min((box.width - 2.0 * inset) / wide, (box.height - 2.0 * inset) / tall);
    middle_ = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
    centre_ = {box.x + 0.5 * box.width, box.middle()};
  }

  Point at(const Point& point) const {
    return {centre_.x + per_unit_ * (point.x - middle_.x),
            centre_.y - per_unit_ * (point.y - middle_.y)};
  }

 private:
  double per_unit_ = 1.0;
  Point middle_, centre_;
};

void draw_diamond(Canvas& canvas, const Point& at, double radius) {
  const auto corners = [&](double r) {
    return std::array<Point, 4>{
        {{at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}}};
  };
  canvas.fill(corners(radius + 1.2), paper);
  canvas.fill(corners(radius), reference_colours.line);
}

void draw_rated(Canvas& canvas, const Point& at, double radius) {
  canvas.ring(at, radius, {.width = 2.0, .colour = paper});
  canvas.ring(at, radius, {.width = 0.9, .colour = ink});
}

void draw_marks(Canvas& canvas, const MapContent& content, const PlaneScale& scale, double radius) {
  for (const auto& [name, point] : content.rated) draw_rated(canvas, scale.at(point), radius);
  for (const auto& [name, point] : content.chosen)
    draw_diamond(canvas, scale.at(point), radius + 0.6);
}

/// Draws the names of films, and returns how many had no room.
std::size_t draw_names(Canvas& canvas, const MapContent& content, const PlaneScale& scale,
                       const Box& box) {
  std::vector<std::pair<std::string, bool>> names;  // and whether chosen
  std::vector<LabelledPoint> points;
  const auto add = [&](const auto& films, bool is_chosen) {
    TextStyle style = label_style;
    style.bold = is_chosen;
    for (const auto& [name, point] : films) {
      names.emplace_back(name, is_chosen);
      points.push_back({scale.at(point), canvas.text_width(name, style) + 1.0, 7.5});
    }
  };
  add(content.chosen, true);
  add(content.rated, false);
  const auto labels = place_labels(points, {}, mark_radius + 1.0, box);
  std::size_t without = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!labels[i]) {
      ++without;
      continue;
    }
    const Box& label = *labels[i];
    const Point nearest = {std::clamp(points[i].at.x, label.x, label.right()),
                           std::clamp(points[i].at.y, label.y, label.bottom())};
    const auto& [name, is_chosen] = names[i];
    const Colour colour = is_chosen ? reference_colours.line : ink;
    const double away = std::hypot(nearest.x - points[i].at.x, nearest.y - points[i].at.y);
    if (away > 5.6) canvas.line(points[i].at, nearest, {.width = 0.5, .colour = colour});
    canvas.text({label.x + 0.5, label.bottom() - 1.7}, name,
                {.size = label_style.size, .colour = colour, .bold = is_chosen});
  }
  return without;
}

std::string axis_text(const MapContent& content, Eigen::Index component) {
  const double explained = content.plane.explained[static_cast<std::size_t>(component)];
  const std::string parts =
      component_text(content.plane, component, content.choice.space.parameters);
  const std::string name = fmt::format("{} principal component, {:.0f} % of the variance",
                                       component == 0 ? "First" : "Second", 100.0 * explained);
  return explained < 1e-9 ? std::string() : fmt::format("{}: {}", name, parts);
}

void draw_key(Canvas& canvas, const MapContent& content) {
  const PlaneScale scale(content, key_box);
  canvas.fill(key_box, panel);
  for (const Point& point : content.candidates) canvas.disc(scale.at(point), 1.1, hairline);
  const std::size_t without = draw_names(canvas, content, scale, key_box);
  draw_marks(canvas, content, scale, mark_radius);
  TextStyle style = map_note;
  style.max_width = key_box.width;
  if (const std::string up = axis_text(content, 1); !up.empty())
    canvas.text({key_box.x, key_box.y - 4.0}, "↑ " + up, style);
  canvas.text({key_box.x, key_box.bottom() + 9.5}, "→ " + axis_text(content, 0), style);
  if (without > 0)
    canvas.text({key_box.x, key_box.bottom() + 19.5},
                fmt::format("Without room for a name: {} film{}", without, without == 1 ? "" : "s"),
                map_note);
}

/// Draws what the marks mean, and returns where to go on.
double draw_legend(Canvas& canvas, const MapContent& content, double x, double y) {
  const auto words = [&](const std::string& text) {
    canvas.text({x + 12.0, y + 2.8}, text, {.size = 8.0});
    y += 14.0;
  };
  draw_rated(canvas, {x + 3.0, y}, mark_radius);
  words(fmt::format("rated film ({})", content.rated.size()));
  draw_diamond(canvas, {x + 3.0, y}, mark_radius + 0.6);
  words(fmt::format("chosen for the next round ({})", content.chosen.size()));
  canvas.disc({x + 3.0, y}, 1.4, hairline);
  words(fmt::format("film that can be made ({})", content.candidates.size()));
  return y;
}

std::string share_text(double share) {
  return std::isnan(share) ? "–" : fmt::format("{:.2f}", share);
}

/// The rounds as a table of four columns, of `width` points.
void draw_rounds(Canvas& canvas, const MapContent& content, double x, double y, double width) {
  constexpr std::size_t most_rounds = 14;
  const std::vector<FilmRound>& rounds = content.choice.rounds;
  canvas.text({x, y}, "Rounds", {.size = 8.5, .bold = true});
  const auto row = [&](double at, const std::array<std::string, 4>& fields, const TextStyle& of) {
    TextStyle style = of;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      style.align = f == 0 ? Align::left : Align::right;
      canvas.text({f == 0 ? x : x + width * static_cast<double>(f + 1) / 4.0, at}, fields[f],
                  style);
    }
  };
  y += 13.0;
  row(y, {"round", "films", "explained", "within 90 %"}, map_note);
  const std::size_t first = rounds.size() > most_rounds ? rounds.size() - most_rounds : 0;
  for (std::size_t r = first; r < rounds.size(); ++r)
    row(y += 11.0,
        {fmt::format("{}", rounds[r].number), fmt::format("{}", rounds[r].films),
         share_text(rounds[r].explained), share_text(rounds[r].covered)},
        {.size = 7.5});
  y += 13.0;
  for (const char* words : {"Of the variance of a round’s mean ratings, predicted from",
                            "the rounds before (in the first, each film from the others),",
                            "and films within their 90 % intervals: means over scales"}) {
    canvas.text({x, y}, words, {.size = 6.5, .colour = quiet_ink, .max_width = width});
    y += 9.0;
  }
}

/// With a true minus.
std::string bar_text(double value) {
  const std::string text = fmt::format("{:.2f}", std::abs(value));
  return value < 0.0 && text != "0.00" ? "−" + text : text;
}

void draw_colour_bar(Canvas& canvas, const Box& area, double low, double high) {
  constexpr int steps = 40;
  constexpr double ends = 30.0;
  const double width = area.width - 2.0 * ends;
  // Each step reaches to the right end, so that there are no seams.
  for (int i = 0; i < steps; ++i)
    canvas.fill({area.x + ends + width * i / steps, area.y, width * (steps - i) / steps, 6.0},
                amount_colour((i + 0.5) / steps));
  canvas.text({area.x + ends - 4.0, area.y + 5.6}, bar_text(low),
              {.size = 7.0, .align = Align::right});
  canvas.text({area.x + area.width - ends + 4.0, area.y + 5.6}, bar_text(high), {.size = 7.0});
}

/// A panel of the map with a value of each candidate.
void draw_values(Canvas& canvas, const MapContent& content, const Eigen::VectorXd& values,
                 const Box& box) {
  canvas.fill(box, map_panel);
  const PlaneScale scale(content, box);
  const double low = values.minCoeff(), span = values.maxCoeff() - low;
  for (std::size_t c = 0; c < content.candidates.size(); ++c) {
    const double value = values[static_cast<Eigen::Index>(c)];
    canvas.disc(scale.at(content.candidates[c]), 1.7,
                amount_colour(span > 0.0 ? (value - low) / span : 0.5));
  }
  draw_marks(canvas, content, scale, 1.9);
  draw_colour_bar(canvas, {box.x, box.bottom() + 5.0, box.width, 6.0}, low, low + span);
}

void draw_scale(Canvas& canvas, const MapContent& content, std::size_t s) {
  const double x = map_margin + static_cast<double>(s % map_columns) * (small_width + column_gap);
  double y = bands_top + static_cast<double>(s / map_columns) * band_height + heading_room;
  const ScaleKnowledge& known = content.choice.next.known[s];
  canvas.text({x, y - 4.0}, content.scales()[s].scale,
              {.size = 8.0, .bold = true, .max_width = small_width - 62.0});
  canvas.text({x + small_width, y - 4.0}, "expected rating",
              {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  draw_values(canvas, content, known.mean, {x, y, small_width, small_height});
  y += small_height + bar_room + heading_room;
  canvas.text({x + small_width, y - 4.0}, "standard deviation",
              {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  draw_values(canvas, content, known.deviation, {x, y, small_width, small_height});
}

}  // namespace

Plot film_map_plot(const FilmChoice& choice) {
  const std::size_t bands = (choice.rated.scales.size() + map_columns - 1) / map_columns;
  const double height = bands_top + static_cast<double>(bands) * band_height + 6.0;
  return {
      "What is known of the films", map_width, height, [&choice](Canvas& canvas) {
        const MapContent content = content_of(choice);
        canvas.text({map_margin, map_margin + 12.0}, "What is known of the films",
                    {.size = 12.0, .bold = true});
        canvas.text({map_margin, map_margin + 27.0},
                    fmt::format("{} of {} films that the examples allow, {}", content.chosen.size(),
                                content.candidates.size(), aim_text(choice.aim)),
                    {.size = 8.5, .colour = quiet_ink});
        if (choice.rated.simulated)
          draw_simulated_mark(canvas, {map_width - map_margin, map_margin}, "Simulated answers");
        draw_key(canvas, content);
        const double x = key_box.right() + 22.0;
        const double y = draw_legend(canvas, content, x, key_box.y + 6.0);
        draw_rounds(canvas, content, x, y + 16.0, map_width - map_margin - x);
        for (std::size_t s = 0; s < choice.rated.scales.size(); ++s) draw_scale(canvas, content, s);
      }};
}

}  // namespace mien::pipeline
