// What the soft shadow on the floor costs and how noisy it is: of the stick figure that the peers
// draw too, under their light alone, walking before a camera that stands, in a window about its
// shadow; once with shadow rays (a triangle hidden in a joint asks for them) and once with lines of
// the light.
//
//   shadow_noise FRAMES REFERENCE [FILE.png]
//
// For each number of samples: processor seconds a frame, the RMS error of linear RGB against
// REFERENCE samples where neither picture shows the figure, and the flicker, the RMS by which that
// error changes from one frame to the next. FILE shows a part of the last frame of standard
// quality 4 times as large, rays to the left, lines to the right.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "render/image/image_io.h"
#include "render/image/tone.h"

#include "peers/walking_scene.h"

namespace {

using namespace mien;
using render::Film;

constexpr render::Window shadow{420, 400, 320, 220};
constexpr render::Window shown{0, 120, 100, 90};  // of that

struct Sequence {
  std::vector<Film> frames;
  double seconds = 0.0;  ///< a frame
};

render::Scene scene_at(const peers::Walk& walk, int frame, bool by_rays) {
  render::Scene scene = peers::scene_of(peers::joints_at(walk, frame));
  scene.sky.zenith = scene.sky.horizon = scene.sky.below = render::Color::Zero();
  if (!by_rays) return scene;
  const render::Vec3 inside = scene.solids.spheres.front().centre;
  const float size = 0.2f * peers::joint_radius;
  render::Mesh mesh;
  mesh.positions = {inside, inside + size * render::Vec3::UnitX(),
                    inside + size * render::Vec3::UnitZ()};
  mesh.normals.assign(3, render::Vec3::UnitY());
  mesh.triangles = {{0, 1, 2}};
  scene.solids.meshes.push_back(mesh);
  return scene;
}

Sequence drawn(const peers::Walk& walk, int frames, const render::Quality& quality, bool by_rays) {
  render::Tracer tracer({.threads = 1});
  render::Camera camera = peers::camera_at(0, false);
  camera.window = shadow;
  Sequence sequence;
  tracer.trace(scene_at(walk, 0, by_rays), camera, quality);  // the set is there
  const std::clock_t start = std::clock();
  for (int f = 0; f < frames; ++f)
    sequence.frames.push_back(tracer.trace(scene_at(walk, f, by_rays), camera, quality));
  sequence.seconds = double(std::clock() - start) / CLOCKS_PER_SEC / frames;
  return sequence;
}

/// Whether no picture shows the figure, which is bluer than grey, here or beside here.
std::vector<bool> floor_in_all(const std::vector<Film>& frames) {
  constexpr int beside = 2;
  const int width = shadow.width, height = shadow.height;
  std::vector<bool> floor(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), true);
  for (const Film& film : frames)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (film.at(x, y)[2] <= 1.005f * film.at(x, y)[0]) continue;
        for (int v = std::max(y - beside, 0); v <= std::min(y + beside, height - 1); ++v)
          for (int u = std::max(x - beside, 0); u <= std::min(x + beside, width - 1); ++u)
            floor[static_cast<std::size_t>(v * width + u)] = false;
      }
  return floor;
}

struct Noise {
  double error = 0.0;
  double flicker = 0.0;
  double bias = 0.0;  ///< mean difference
};

Noise noise_of(const std::vector<Film>& frames, const std::vector<Film>& reference) {
  const std::vector<bool> floor = floor_in_all(reference);
  double squares = 0.0, changes = 0.0, sum = 0.0, count = 0.0, pairs = 0.0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    for (std::size_t i = 0; i < frames[f].channels.size(); ++i) {
      if (!floor[i / 3]) continue;
      const double off = double(frames[f].channels[i]) - double(reference[f].channels[i]);
      squares += off * off;
      sum += off;
      ++count;
      if (f == 0) continue;
      const double before =
          double(frames[f - 1].channels[i]) - double(reference[f - 1].channels[i]);
      changes += (off - before) * (off - before);
      ++pairs;
    }
  }
  return {std::sqrt(squares / count), std::sqrt(changes / std::max(pairs, 1.0)), sum / count};
}

render::Image8 enlarged(const Film& left, const Film& right) {
  constexpr int times = 4, gap = 8;
  const render::Image8 pictures[] = {render::to_srgb8(cut_out(left, shown)),
                                     render::to_srgb8(cut_out(right, shown))};
  const int width = times * shown.width, height = times * shown.height;
  render::Image8 out(2 * width + gap, height);
  for (int k = 0; k < 2; ++k)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        std::copy_n(pictures[k].at(x / times, y / times), 3, out.at(x + k * (width + gap), y));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int frames = argc > 2 ? std::atoi(argv[1]) : 0;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 0;
  if (frames < 1 || frames > peers::frames_in_all || samples < 1) {
    std::fprintf(stderr, "shadow_noise FRAMES REFERENCE [FILE.png]\n");
    return 2;
  }
  const peers::Walk walk = peers::walk();
  render::Quality thorough = render::final_quality();
  thorough.samples_per_pixel = samples;
  thorough.floor_sky_noise = render::standard_quality().floor_sky_noise;
  thorough.floor_sky_tolerance = render::standard_quality().floor_sky_tolerance;
  thorough.seed = 77;
  const std::vector<Film> reference = drawn(walk, frames, thorough, false).frames;
  std::printf("samples  of       s/frame      error    flicker       bias\n");
  for (const int count : {1, 4, 16, 64}) {
    render::Quality quality = render::standard_quality();
    quality.samples_per_pixel = count;
    const Sequence rays = drawn(walk, frames, quality, true);
    const Sequence lines = drawn(walk, frames, quality, false);
    for (const auto& [name, sequence] : {std::pair{"rays", &rays}, std::pair{"lines", &lines}}) {
      const Noise noise = noise_of(sequence->frames, reference);
      std::printf("%7d  %-6s %9.4f  %9.5f  %9.5f  %9.6f\n", count, name, sequence->seconds,
                  noise.error, noise.flicker, noise.bias);
    }
    if (argc > 3 && count == 16)
      render::write_png(argv[3], enlarged(rays.frames.back(), lines.frames.back()));
  }
  return 0;
}
