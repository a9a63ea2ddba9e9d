#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/chains/experiment/chain_figure_parts.h"

namespace mien::pipeline {

namespace {

constexpr double ridge_height = 26.0;
constexpr double ridge_width = 360.0;
constexpr double dimension_gap = 26.0;
constexpr double map_size = 108.0;
constexpr double map_gap = 14.0;
constexpr int maps_per_row = 4;
constexpr int map_cells = 52;
constexpr int pixels_per_cell = 5;

/// The samples of all words as columns, in units of the ranges, and where those of each word begin.
struct AllSamples {
  Eigen::MatrixXd values;
  std::vector<Eigen::Index> begins;  ///< by word, and the end
};

AllSamples all_samples(const ChainResults& results) {
  const auto dimensions = static_cast<Eigen::Index>(results.design.dimensions.size());
  AllSamples all{.begins = {0}};
  for (const WordSamples& word : results.words)
    all.begins.push_back(all.begins.back() + word.samples);
  all.values.resize(dimensions, all.begins.back());
  for (std::size_t w = 0; w < results.words.size(); ++w)
    for (Eigen::Index d = 0; d < dimensions; ++d) {
      const DimensionRange& range = results.design.space[static_cast<std::size_t>(d)];
      Eigen::Index at = all.begins[w];
      for (const auto& chain : results.words[w].dimensions[static_cast<std::size_t>(d)].values)
        for (const double value : chain)
          all.values(d, at++) = (value - range.low) / (range.high - range.low);
    }
  return all;
}

Eigen::VectorXd prototype_in_ranges(const ChainResults& results, const WordSamples& word) {
  const std::vector<double> point = word.prototype();
  Eigen::VectorXd shares(std::ssize(point));
  for (std::size_t d = 0; d < point.size(); ++d) {
    const DimensionRange& range = results.design.space[d];
    shares[static_cast<Eigen::Index>(d)] = (point[d] - range.low) / (range.high - range.low);
  }
  return shares;
}

/// A curve above its line: as high as the box at `most`.
void draw_ridge(Canvas& canvas, const SampleDensity& of, double most, const Box& box) {
  std::vector<Point> outline = {{box.x, box.bottom()}};
  for (std::size_t i = 0; i < of.places.size(); ++i)
    outline.push_back(
        {box.x + box.width * static_cast<double>(i) / static_cast<double>(of.places.size() - 1),
         box.bottom() - box.height * of.density[i] / most});
  outline.push_back({box.right(), box.bottom()});
  canvas.fill(outline, created_colours.light, 0.5);
  canvas.polyline(std::span(outline).subspan(1, outline.size() - 2),
                  {.width = 0.8, .colour = created_colours.line});
  canvas.line({box.x, box.bottom()}, {box.right(), box.bottom()},
              {.width = 0.4, .colour = hairline});
}

void draw_dimension(Canvas& canvas, const ChainResults& results, std::size_t d, double top) {
  const DimensionRange& range = results.design.space[d];
  const double axis = figure_margin + names_width;
  canvas.text({figure_margin, top + 10.0}, results.design.dimensions[d],
              {.size = 8.5, .bold = true});
  for (const double end : {0.0, 1.0})
    canvas.text({axis + end * ridge_width, top + 10.0},
                fmt::format("{:.2f}", std::lerp(range.low, range.high, end)),
                {.size = 7.0, .colour = quiet_ink, .align = Align::centre});
  std::vector<SampleDensity> densities;
  double most = 0.0;
  for (const WordSamples& word : results.words) {
    densities.push_back(word.dimensions[d].density(range));
    most = std::max(most, std::ranges::max(densities.back().density));
  }
  for (std::size_t w = 0; w < results.words.size(); ++w) {
    const Box box{axis, top + 14.0 + static_cast<double>(w) * ridge_height + 4.0, ridge_width,
                  ridge_height - 4.0};
    canvas.text({figure_margin + 8.0, box.bottom() - 2.0}, results.words[w].word,
                {.size = 8.0, .max_width = names_width - 14.0});
    draw_ridge(canvas, densities[w], most, box);
    const double mean =
        axis + ridge_width * share_of(range, results.words[w].dimensions[d].mean.mean);
    canvas.disc({mean, box.bottom()}, 2.2, created_colours.line);
  }
}

render::Image8 picture_of(const DensityMap& map, double most) {
  const int size = map_cells * pixels_per_cell;
  render::Image8 image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      // From the middle of a cell to that of the next, linearly.
      const auto between = [](int pixel) {
        return std::clamp((pixel + 0.5) / pixels_per_cell - 0.5, 0.0, map_cells - 1.0);
      };
      const double column = between(x), row = map_cells - 1.0 - between(y);
      const auto c = static_cast<Eigen::Index>(column), r = static_cast<Eigen::Index>(row);
      const Eigen::Index c1 = std::min<Eigen::Index>(c + 1, map_cells - 1);
      const Eigen::Index r1 = std::min<Eigen::Index>(r + 1, map_cells - 1);
      const double a = column - static_cast<double>(c), b = row - static_cast<double>(r);
      const double density = std::lerp(std::lerp(map.density(r, c), map.density(r, c1), a),
                                       std::lerp(map.density(r1, c), map.density(r1, c1), a), b);
      const Colour colour = amount_colour(density / most);
      std::uint8_t* pixel = image.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(std::lround(255.0 * colour.red));
      pixel[1] = static_cast<std::uint8_t>(std::lround(255.0 * colour.green));
      pixel[2] = static_cast<std::uint8_t>(std::lround(255.0 * colour.blue));
    }
  return image;
}

/// The maps of all words, in one scale of colours.
struct Maps {
  SamplePlane plane;
  std::vector<DensityMap> of;
  double most = 0.0;
};

Maps maps_of(const ChainResults& results) {
  const AllSamples all = all_samples(results);
  Maps maps{.plane = sample_plane(all.values)};
  Eigen::Matrix2Xd points =
      maps.plane.axes.transpose() * (all.values.colwise() - maps.plane.centre);
  const Eigen::Vector2d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const double width = std::max(1.2 * (high - low).maxCoeff(), 0.05);
  for (std::size_t w = 0; w < results.words.size(); ++w) {
    maps.of.push_back(
        density_map(points.middleCols(all.begins[w], all.begins[w + 1] - all.begins[w]),
                    middle.x() - 0.5 * width, middle.y() - 0.5 * width, width, map_cells));
    maps.most = std::max(maps.most, maps.of.back().density.maxCoeff());
  }
  return maps;
}

/// "Component 1 (62 %): 0.80 quickness − 0.41 largeness", of the loadings those of 0.3 and more.
std::string component_text(const ChainResults& results, const SamplePlane& plane, int component) {
  std::string text = fmt::format("component {} ({:.0f} % of the variance):", component + 1,
                                 100.0 * plane.shares[static_cast<std::size_t>(component)]);
  bool is_first = true;
  for (Eigen::Index d = 0; d < plane.axes.rows(); ++d) {
    const double loading = plane.axes(d, component);
    if (std::abs(loading) < 0.3) continue;
    text += fmt::format(" {}{:.2f} {}",
                        loading < 0.0 ? "− "
                        : is_first    ? ""
                                      : "+ ",
                        std::abs(loading), results.design.dimensions[static_cast<std::size_t>(d)]);
    is_first = false;
  }
  return text;
}

void draw_map(Canvas& canvas, const ChainResults& results, const Maps& maps, std::size_t word,
              const Box& box) {
  const DensityMap& map = maps.of[word];
  canvas.picture(box, picture_of(map, maps.most));
  canvas.outline(box, {.width = 0.5, .colour = hairline});
  canvas.text({box.x, box.y - 5.0}, results.words[word].word,
              {.size = 8.5, .bold = true, .max_width = box.width});
  for (std::size_t w = 0; w < results.words.size(); ++w) {
    const Eigen::Vector2d at = maps.plane.at(prototype_in_ranges(results, results.words[w]));
    const Point point{box.x + box.width * (at.x() - map.low_x) / map.width,
                      box.bottom() - box.height * (at.y() - map.low_y) / map.width};
    canvas.disc(point, w == word ? 3.4 : 2.0, paper);
    canvas.ring(point, w == word ? 3.4 : 2.0, {.width = w == word ? 1.4 : 0.8, .colour = ink});
  }
}

void draw_maps(Canvas& canvas, const ChainResults& results, double top) {
  const Maps maps = maps_of(results);
  canvas.text({figure_margin, top + 8.0},
              "Density of the samples in the plane in which they vary most",
              {.size = 8.5, .bold = true});
  const TextStyle quiet{.size = 7.5, .colour = quiet_ink, .max_width = names_width + ridge_width};
  canvas.text({figure_margin, top + 21.0}, "right: " + component_text(results, maps.plane, 0),
              quiet);
  canvas.text({figure_margin, top + 32.0}, "up: " + component_text(results, maps.plane, 1), quiet);
  canvas.text(
      {figure_margin, top + 43.0},
      "light to dark: low to high; large circle: prototype of the word; small: of the others",
      quiet);
  for (std::size_t w = 0; w < results.words.size(); ++w) {
    const auto column = static_cast<double>(w % maps_per_row);
    const auto row = static_cast<double>(w / maps_per_row);
    draw_map(canvas, results, maps, w,
             {figure_margin + column * (map_size + map_gap),
              top + 65.0 + row * (map_size + map_gap + 14.0), map_size, map_size});
  }
}

}  // namespace

Plot densities_plot(const ChainResults& results) {
  const auto words = static_cast<double>(results.words.size());
  const auto dimensions = static_cast<double>(results.design.dimensions.size());
  const double each = words * ridge_height + dimension_gap;
  const double curves = 2.0 * figure_margin + figure_header + dimensions * each;
  const bool has_maps = results.design.dimensions.size() > 1;
  const double rows = std::ceil(words / maps_per_row);
  const double maps = has_maps ? 57.0 + rows * (map_size + map_gap + 14.0) : 0.0;
  const double width = 2.0 * figure_margin + names_width + ridge_width + 16.0;
  return {"Densities", width, curves + maps,
          [&results, width, each, dimensions, has_maps](Canvas& canvas) {
            draw_figure_header(canvas, results, "Densities",
                               "Kernel estimates of the samples of each word; dots: prototypes",
                               width);
            const double top = figure_margin + figure_header;
            for (std::size_t d = 0; d < results.design.dimensions.size(); ++d)
              draw_dimension(canvas, results, d, top + static_cast<double>(d) * each);
            if (has_maps) draw_maps(canvas, results, top + dimensions * each + 6.0);
          }};
}

}  // namespace mien::pipeline
