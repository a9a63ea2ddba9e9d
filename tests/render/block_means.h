#pragma once

#include <Eigen/Core>

#include "render/tracer/tracer.h"

namespace mien::render::test {

inline constexpr int block_size = 10;  ///< pixels

/// Means of the second channel over blocks of 10 x 10 pixels.
inline Eigen::ArrayXd block_means(const Framebuffer& framebuffer) {
  const int across = framebuffer.width / block_size, down = framebuffer.height / block_size;
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(across * down);
  for (int y = 0; y < down * block_size; ++y)
    for (int x = 0; x < across * block_size; ++x)
      sums[y / block_size * across + x / block_size] +=
          static_cast<double>(framebuffer.at(x, y)[1]);
  return sums / (block_size * block_size);
}

struct BlockMeans {
  Eigen::ArrayXd mean;
  Eigen::ArrayXd error;  ///< its standard error
};

/// Means of the blocks over pictures with the seeds `seed` …
inline BlockMeans mean_of_pictures(const View& view, std::uint64_t seed, int pictures) {
  Tracer tracer;
  Eigen::ArrayXd sum, squares;
  for (int k = 0; k < pictures; ++k) {
    View next = view;
    next.quality.seed = seed + static_cast<std::uint64_t>(k);
    const Eigen::ArrayXd means = block_means(tracer.render_view(std::move(next)).color);
    if (k == 0) sum = squares = Eigen::ArrayXd::Zero(means.size());
    sum += means;
    squares += means.square();
  }
  const Eigen::ArrayXd mean = sum / pictures;
  return {mean, ((squares / pictures - mean.square()).max(0.0) / (pictures - 1)).sqrt()};
}

}  // namespace mien::render::test
