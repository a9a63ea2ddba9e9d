// What the soft shadows on the floor cost and how noisy they are: of the stick figure that the
// peers draw too, walking before a camera that stands, in a window about its feet and its shadow.
//
//   shadow_noise FRAMES REFERENCE [light|sky [FILE.png]]
//
// light: under their light alone, with shadow rays of each pixel, and with fewer that neighbouring
// pixels share. sky: under their sky alone, looked at from each pixel near the feet, and from
// points between which it is interpolated.
//
// For each number of samples: processor seconds a frame, the RMS error of linear RGB against
// REFERENCE samples where neither picture shows the figure, and the flicker, the RMS by which that
// error changes from one frame to the next. FILE shows a part of the last frame of standard
// quality 4 times as large, both ways side by side.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "render/image/image_io.h"
#include "render/image/tone.h"

#include "peers/walking_scene.h"

namespace {

using namespace mien;
using render::Framebuffer;

constexpr render::Window shadow{420, 400, 320, 220};

/// What is measured.
struct Subject {
  bool sky;              ///< or the light
  const char* ways[2];   ///< of finding what the figure hides of it
  render::Window shown;  ///< a part of `shadow`
};
constexpr Subject light{false, {"own", "shared"}, {0, 120, 100, 90}};
constexpr Subject sky{true, {"pixels", "points"}, {160, 128, 100, 90}};

struct Sequence {
  std::vector<Framebuffer> frames;
  double seconds = 0.0;  ///< a frame
};

render::Scene scene_at(const Subject& subject, const peers::Walk& walk, int frame) {
  render::Scene scene = peers::scene_of(peers::joints_at(walk, frame));
  if (subject.sky) {
    scene.lights.clear();
  } else {
    scene.sky.zenith = scene.sky.horizon = scene.sky.below = render::Color::Zero();
  }
  return scene;
}

Sequence drawn(const Subject& subject, int way, const peers::Walk& walk, int frames,
               render::Quality quality) {
  render::Tracer tracer({.threads = 1});
  render::Camera camera = peers::camera_at(0, peers::View::standing);
  camera.window = shadow;
  if (subject.sky) quality.floor_sky_smooth = way != 0;
  if (!subject.sky && way == 0) quality.floor_sharing_pixels = 0;
  Sequence sequence;
  tracer.trace(scene_at(subject, walk, 0), camera, quality);  // the set is there
  const std::clock_t start = std::clock();
  for (int f = 0; f < frames; ++f)
    sequence.frames.push_back(tracer.trace(scene_at(subject, walk, f), camera, quality));
  sequence.seconds = double(std::clock() - start) / CLOCKS_PER_SEC / frames;
  return sequence;
}

/// Whether no picture shows the figure, which is bluer than grey, here or beside here.
std::vector<bool> floor_in_all(const std::vector<Framebuffer>& frames) {
  constexpr int beside = 2;
  const int width = shadow.width, height = shadow.height;
  std::vector<bool> floor(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), true);
  for (const Framebuffer& film : frames)
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

Noise noise_of(const std::vector<Framebuffer>& frames, const std::vector<Framebuffer>& reference) {
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

render::Image8 enlarged(const Framebuffer& left, const Framebuffer& right,
                        const render::Window& shown) {
  constexpr int times = 4, gap = 8;
  const render::Image8 pictures[] = {render::to_srgb8(crop(left, shown)),
                                     render::to_srgb8(crop(right, shown))};
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
  const std::string what = argc > 3 ? argv[3] : "light";
  if (frames < 1 || frames > peers::frames_in_all || samples < 1 ||
      (what != "light" && what != "sky")) {
    std::fprintf(stderr, "shadow_noise FRAMES REFERENCE [light|sky [FILE.png]]\n");
    return 2;
  }
  const Subject& subject = what == "sky" ? sky : light;
  const peers::Walk walk = peers::walk();
  render::Quality thorough = render::final_quality();
  thorough.samples_per_pixel = samples;
  thorough.floor_sky_noise = render::standard_quality().floor_sky_noise;
  // Of the sky nothing is interpolated.
  thorough.floor_sky_tolerance =
      subject.sky ? 0.0f : render::standard_quality().floor_sky_tolerance;
  thorough.seed = 77;
  const std::vector<Framebuffer> reference = drawn(subject, 1, walk, frames, thorough).frames;
  std::printf("samples  of       s/frame      error    flicker       bias\n");
  for (const int count : {1, 4, 16, 64}) {
    render::Quality quality = render::standard_quality();
    quality.samples_per_pixel = count;
    std::vector<Framebuffer> last;
    for (const int way : {0, 1}) {
      const Sequence sequence = drawn(subject, way, walk, frames, quality);
      const Noise noise = noise_of(sequence.frames, reference);
      std::printf("%7d  %-6s %9.4f  %9.5f  %9.5f  %9.6f\n", count, subject.ways[way],
                  sequence.seconds, noise.error, noise.flicker, noise.bias);
      last.push_back(sequence.frames.back());
    }
    if (argc > 4 && count == 16)
      render::write_png(argv[4], enlarged(last[0], last[1], subject.shown));
  }
  return 0;
}
