#include "render/video/colour_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/image/bayer.h"

namespace mien::render {

namespace {

constexpr int most_colours = 255;
constexpr int refinements = 6;
constexpr std::uint8_t unknown = most_colours;  ///< number of the transparent entry

using Colour = std::array<double, 3>;

struct WeightedColour {
  Colour colour;
  double weight;
};

/// Colours that one entry stands for so far.
struct Cluster {
  std::span<WeightedColour> members;
  Colour mean{};
  double weight = 0.0;
  int widest = 0;      ///< axis of most variance
  double error = 0.0;  ///< weighted sum of squares along all axes

  explicit Cluster(std::span<WeightedColour> given) : members(given) {
    Colour squares{};
    for (const auto& [colour, w] : members) {
      weight += w;
      for (std::size_t c = 0; c < 3; ++c) {
        mean[c] += w * colour[c];
        squares[c] += w * colour[c] * colour[c];
      }
    }
    double most = -1.0;
    for (std::size_t c = 0; c < 3; ++c) {
      mean[c] /= weight;
      const double variance = squares[c] - weight * mean[c] * mean[c];
      error += std::max(variance, 0.0);
      if (variance > most) {
        most = variance;
        widest = static_cast<int>(c);
      }
    }
    if (members.size() < 2) error = 0.0;
  }

  /// The two parts on either side of the mean.
  std::array<Cluster, 2> halves() const {
    const auto axis = static_cast<std::size_t>(widest);
    const auto below = [&](const WeightedColour& w) { return w.colour[axis] <= mean[axis]; };
    const auto middle = std::stable_partition(members.begin(), members.end(), below);
    auto first = static_cast<std::size_t>(middle - members.begin());
    first = std::clamp<std::size_t>(first, 1, members.size() - 1);
    return {Cluster(members.first(first)), Cluster(members.subspan(first))};
  }
};

std::vector<WeightedColour> colours_of(const ColourHistogram& histogram) {
  std::vector<WeightedColour> colours;
  for (const auto& [count, sum] : histogram.cells()) {
    if (count == 0) continue;
    const auto n = static_cast<double>(count);
    colours.push_back({{static_cast<double>(sum[0]) / n, static_cast<double>(sum[1]) / n,
                        static_cast<double>(sum[2]) / n},
                       n});
  }
  return colours;
}

double squared_distance(const Colour& a, const Colour& b) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

std::size_t nearest_of(const std::vector<Colour>& table, const Colour& colour) {
  std::size_t best = 0;
  double least = squared_distance(table[0], colour);
  for (std::size_t i = 1; i < table.size(); ++i) {
    const double distance = squared_distance(table[i], colour);
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

std::vector<Colour> split(std::vector<WeightedColour>& colours) {
  std::vector<Cluster> clusters{Cluster(colours)};
  while (clusters.size() < most_colours) {
    const auto worst =
        std::max_element(clusters.begin(), clusters.end(),
                         [](const Cluster& a, const Cluster& b) { return a.error < b.error; });
    if (worst->error <= 0.0) break;
    const std::array<Cluster, 2> parts = worst->halves();
    *worst = parts[0];
    clusters.push_back(parts[1]);
  }
  std::vector<Colour> table;
  for (const Cluster& cluster : clusters) table.push_back(cluster.mean);
  return table;
}

/// Lloyd's iteration; returns the mean squared error of a channel before the last step.
double refine(const std::vector<WeightedColour>& colours, std::vector<Colour>& table) {
  double error = 0.0;
  for (int round = 0; round < refinements; ++round) {
    std::vector<WeightedColour> sums(table.size(), {{}, 0.0});
    error = 0.0;
    double total = 0.0;
    for (const auto& [colour, weight] : colours) {
      const std::size_t i = nearest_of(table, colour);
      error += weight * squared_distance(table[i], colour) / 3.0;
      total += weight;
      sums[i].weight += weight;
      for (std::size_t c = 0; c < 3; ++c) sums[i].colour[c] += weight * colour[c];
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (sums[i].weight <= 0.0) continue;
      for (std::size_t c = 0; c < 3; ++c) table[i][c] = sums[i].colour[c] / sums[i].weight;
    }
    error /= total;
  }
  return error;
}

}  // namespace

void ColourHistogram::add(const Image8& frame) {
  for (std::size_t i = 0; i + 2 < frame.channels.size(); i += 3) {
    const std::uint8_t* p = frame.channels.data() + i;
    Cell& cell = cells_[static_cast<std::size_t>(p[0] >> 2 << 12 | p[1] >> 2 << 6 | p[2] >> 2)];
    ++cell.count;
    for (std::size_t c = 0; c < 3; ++c) cell.sum[c] += p[c];
  }
}

ColourTable::ColourTable(const ColourHistogram& histogram)
    : nearest_(std::size_t{1} << 21, unknown) {
  std::vector<WeightedColour> colours = colours_of(histogram);
  if (colours.empty()) colours.push_back({{}, 1.0});
  colours_ = split(colours);
  const double error = refine(colours, colours_);
  for (Colour& colour : colours_) {
    for (double& channel : colour) channel = std::round(channel);
  }
  // Evenly spaced colours a step apart have a mean squared error of step² / 12.
  const double step = std::sqrt(12.0 * error);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      offsets_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
          static_cast<int>(std::lround(step * ((bayer(x, y) + 0.5) / 64.0 - 0.5)));
    }
  }
}

void ColourTable::copy_entries(std::uint32_t* entries) const {
  std::fill_n(entries, 256, 0u);
  for (std::size_t i = 0; i < colours_.size(); ++i) {
    const auto channel = [&](std::size_t c) { return static_cast<std::uint32_t>(colours_[i][c]); };
    entries[i] = 0xff000000u | channel(0) << 16 | channel(1) << 8 | channel(2);
  }
  for (std::size_t i = colours_.size(); i < most_colours; ++i) entries[i] = 0xff000000u;
}

std::uint8_t ColourTable::nearest(int red, int green, int blue) {
  std::uint8_t& known =
      nearest_[static_cast<std::size_t>(red >> 1 << 14 | green >> 1 << 7 | blue >> 1)];
  if (known == unknown) {
    const auto middle = [](int channel) { return (channel & ~1) + 0.5; };
    known =
        static_cast<std::uint8_t>(nearest_of(colours_, {middle(red), middle(green), middle(blue)}));
  }
  return known;
}

void ColourTable::index(const Image8& frame, std::uint8_t* numbers, int stride) {
  const auto dithered = [](int channel, int offset) {
    return std::clamp(channel + offset, 0, 255);
  };
  for (int y = 0; y < frame.height; ++y) {
    std::uint8_t* row = numbers + static_cast<std::ptrdiff_t>(y) * stride;
    const auto& offsets = offsets_[static_cast<std::size_t>(y % 8)];
    for (int x = 0; x < frame.width; ++x) {
      const std::uint8_t* p = frame.at(x, y);
      const int offset = offsets[static_cast<std::size_t>(x % 8)];
      row[x] = nearest(dithered(p[0], offset), dithered(p[1], offset), dithered(p[2], offset));
    }
  }
}

}  // namespace mien::render
