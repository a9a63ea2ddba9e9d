// The scene that mien and its peers draw (walking_scene.h), for comparison with them.
//
//   peer_scene write SCENE.json            for the peers
//   peer_scene measure FRAMES REFERENCE [SAMPLES…]
//                                          draws it with both cores at several numbers of samples,
//                                          and prints JSON: seconds a frame and the RMS error of
//                                          linear RGB of the last of FRAMES against REFERENCE
//                                          samples, for a camera that stands and one that goes
//                                          round the figure. The time is that of a film of 24
//                                          frames, drawn as those of a film are, two in flight;
//                                          what persists was made before
//   peer_scene draw FRAMES SAMPLES standing|moving
//                                          draws it on one thread and prints processor seconds a
//                                          frame: for profilers, and to hold two builds side by
//                                          side
//   peer_scene picture FRAME SAMPLES FILE  draws one frame before the standing camera and writes
//                                          its beauty, albedo and normals, one film after the
//                                          other, as 32-bit floats, the first row at the top

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "peers/walking_scene.h"

namespace {

using namespace mien;
using namespace mien::peers;
using nlohmann::json;

json numbers(const render::Vec3& v) { return {v.x(), v.y(), v.z()}; }

void write_scene(const motion::Clip& clip, const std::string& file) {
  json out;
  const render::Scene scene = scene_of(joints_at(clip, 0));
  const render::AreaLight& light = scene.lights[0];
  out["joint_radius"] = joint_radius;
  out["bone_radius"] = bone_radius;
  out["albedo"] = {0.2, 0.35, 0.6};
  out["floor_albedo"] = 0.5;
  out["sky"] = 0.6;
  out["light"] = {{"centre", numbers(light.centre)},
                  {"half_u", numbers(light.half_u)},
                  {"half_v", numbers(light.half_v)},
                  {"radiance", light.radiance.x()}};
  out["vertical_field_of_view"] = camera_at(0, false).vertical_field_of_view;
  out["parents"] = joints_at(clip, 0).parents;
  for (int f = 0; f < frames_in_all; ++f) {
    json frame;
    for (const render::Vec3& place : joints_at(clip, f).places)
      frame["joints"].push_back(numbers(place));
    frame["standing"] = {{"position", numbers(camera_at(f, false).position)},
                         {"target", numbers(camera_at(f, false).target)}};
    frame["moving"] = {{"position", numbers(camera_at(f, true).position)},
                       {"target", numbers(camera_at(f, true).target)}};
    out["frames"].push_back(frame);
  }
  std::ofstream(file) << out;
}

double rms(const render::Framebuffer& film, const render::Framebuffer& reference) {
  double squares = 0.0;
  for (std::size_t i = 0; i < film.channels.size(); ++i) {
    const double off = static_cast<double>(film.channels[i] - reference.channels[i]);
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(film.channels.size()));
}

render::Quality quality_of(int samples) {
  render::Quality quality = samples <= 4    ? render::draft_quality()
                            : samples >= 64 ? render::final_quality()
                                            : render::standard_quality();
  quality.samples_per_pixel = samples;
  return quality;
}

/// Draws frames as those of a film are: two in flight, and of each its light, part by part.
render::Framebuffer draw_frames(render::Tracer& tracer, const motion::Clip& clip, bool moving,
                                int frames, const render::Quality& quality) {
  struct Flight {
    render::PreparedView ready;
    render::Framebuffer film;
  };
  std::array<Flight, 2> flights;
  const auto flight = [&](std::size_t f) -> Flight& { return flights[f % flights.size()]; };
  const auto begin = [&](std::size_t number) {
    const int f = static_cast<int>(number);
    if (f == frames) return false;
    const render::Camera camera = camera_at(f, moving);
    if (flight(number).film.channels.empty())
      flight(number).film = render::Framebuffer(camera.width, camera.height);
    flight(number).ready = tracer.prepare({scene_of(joints_at(clip, f)), camera, quality});
    return true;
  };
  const auto draw = [&](std::size_t number) {
    tracer.draw(std::move(flight(number).ready), [&](const render::RenderedRegion& part) {
      const auto& [x, y, width, height] = part.pixels;
      for (int row = 0; row < height; ++row)
        std::copy_n(part.framebuffer.at(x, y + row), 3 * width,
                    flight(number).film.at(part.x, part.y + row));
    });
  };
  tracer.for_frames({begin, draw, [](std::size_t) {}}, static_cast<int>(flights.size()));
  return std::move(flight(static_cast<std::size_t>(frames - 1)).film);
}

constexpr int timed_frames = 24;

json measure(const motion::Clip& clip, bool moving, int frames, int reference_samples,
             const std::vector<int>& counts) {
  render::Tracer tracer;
  // Against plain sampling: every ray of its own, nothing interpolated.
  render::Quality thorough = quality_of(reference_samples);
  thorough.floor_sky_tolerance = 0.0f;
  thorough.seed = 1234567;
  const int last = frames - 1;
  const render::Scene shown = scene_of(joints_at(clip, last));
  const render::Framebuffer reference = tracer.trace(shown, camera_at(last, moving), thorough);
  json rows;
  for (const int samples : counts) {
    render::Tracer fresh;
    const render::Framebuffer film = draw_frames(fresh, clip, moving, frames, quality_of(samples));
    const auto start = std::chrono::steady_clock::now();
    draw_frames(fresh, clip, moving, timed_frames, quality_of(samples));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    rows.push_back({{"samples", samples},
                    {"seconds", taken.count() / timed_frames},
                    {"error", rms(film, reference)}});
  }
  return rows;
}

/// Processor seconds a frame, after a first one that shows the set.
double drawing_seconds(const motion::Clip& clip, bool moving, int frames, int samples) {
  render::Tracer tracer({.threads = 1});
  const auto draw = [&](int f) {
    tracer.trace(scene_of(joints_at(clip, f)), camera_at(f, moving), quality_of(samples));
  };
  draw(0);
  const std::clock_t start = std::clock();
  for (int f = 0; f < frames; ++f) draw(f);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / frames;
}

void write_picture(const motion::Clip& clip, int frame, int samples, const std::string& file) {
  render::Quality quality = quality_of(samples);
  quality.floor_sky_tolerance = 0.0f;
  const render::Layers layers =
      render::Tracer().layers(scene_of(joints_at(clip, frame)), camera_at(frame, false), quality);
  std::ofstream out(file, std::ios::binary);
  for (const render::Framebuffer* film : {&layers.beauty, &layers.albedo, &layers.normal}) {
    out.write(reinterpret_cast<const char*>(film->channels.data()),
              static_cast<std::streamsize>(film->channels.size() * sizeof(float)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Walk clip = walk();
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "write" && argc == 3) {
    write_scene(clip, argv[2]);
    return 0;
  }
  if (what == "measure" && argc >= 4) {
    const int frames = std::atoi(argv[2]), reference = std::atoi(argv[3]);
    if (frames < 1 || frames > frames_in_all || reference < 1) return 2;
    std::vector<int> counts;
    for (int i = 4; i < argc; ++i) counts.push_back(std::max(std::atoi(argv[i]), 2));
    if (counts.empty()) counts = {2, 4, 8, 16, 32, 64};
    std::cout << json{{"standing", measure(clip, false, frames, reference, counts)},
                      {"moving", measure(clip, true, frames, reference, counts)}}
              << '\n';
    return 0;
  }
  if (what == "draw" && argc == 5) {
    const int frames = std::atoi(argv[2]), samples = std::atoi(argv[3]);
    if (frames < 1 || frames > frames_in_all || samples < 2) return 2;
    std::cout << drawing_seconds(clip, std::string(argv[4]) == "moving", frames, samples) << '\n';
    return 0;
  }
  if (what == "picture" && argc == 5) {
    const int frame = std::atoi(argv[2]), samples = std::atoi(argv[3]);
    if (frame < 0 || frame >= frames_in_all || samples < 1) return 2;
    write_picture(clip, frame, samples, argv[4]);
    return 0;
  }
  std::cerr << "peer_scene write SCENE.json | peer_scene measure FRAMES REFERENCE [SAMPLES…] | "
               "peer_scene draw FRAMES SAMPLES standing|moving | "
               "peer_scene picture FRAME SAMPLES FILE\n";
  return 2;
}
