#include <algorithm>
#include <cstdlib>

#include "pipeline/regression/comparison/frame_alignment.h"

namespace mien::pipeline {

namespace {

constexpr double mirrored_share = 0.25;

/// Sum of all channels' differences of frames of one number.
double distance_when(Mirroring mirroring, const std::vector<Thumbnail>& before,
                     const std::vector<Thumbnail>& now, int width, int height) {
  double sum = 0.0;
  render::Image8 picture(width, height);
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
    picture.channels = now[i];
    const render::Image8 turned = mirrored(picture, mirroring);
    for (std::size_t c = 0; c < before[i].size(); ++c)
      sum += std::abs(int{before[i][c]} - int{turned.channels[c]});
  }
  return sum;
}

}  // namespace

std::string_view name_of(Mirroring mirroring) {
  constexpr std::string_view names[] = {"", "mirrored: left and right are swapped",
                                        "mirrored: top and bottom are swapped", "turned by 180°"};
  return names[static_cast<std::size_t>(mirroring)];
}

render::Image8 mirrored(const render::Image8& picture, Mirroring mirroring) {
  const bool across = mirroring == Mirroring::left_right || mirroring == Mirroring::half_turn;
  const bool down = mirroring == Mirroring::upside_down || mirroring == Mirroring::half_turn;
  render::Image8 result(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto* from =
          picture.at(across ? picture.width - 1 - x : x, down ? picture.height - 1 - y : y);
      std::copy_n(from, 3, result.at(x, y));
    }
  }
  return result;
}

Mirroring mirroring_of(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                       int width, int height) {
  const double as_it_is = distance_when(Mirroring::none, before, now, width, height);
  Mirroring best = Mirroring::none;
  double least = mirrored_share * as_it_is;
  for (const Mirroring one :
       {Mirroring::left_right, Mirroring::upside_down, Mirroring::half_turn}) {
    const double distance = distance_when(one, before, now, width, height);
    if (!(distance < least)) continue;
    least = distance;
    best = one;
  }
  return best;
}

}  // namespace mien::pipeline
