// The scenes that mien and its peers draw (walking_scene.h, walking_mannequin.h), for comparison
// with them. The first argument may be --figure=mannequin, or --figure=flat-mannequin for one whose
// triangles are not shaded smoothly; the figure is made of sticks otherwise.
//
//   peer_scene write SCENE.json            for the peers; meshes are in SCENE.json.vertices: of
//                                          each frame all positions, then all normals, 32-bit
//                                          floats
//   peer_scene measure FRAMES REFERENCE [SAMPLES…]
//                                          draws it with both cores at several numbers of samples,
//                                          and prints JSON: seconds a frame and the RMS error of
//                                          linear RGB of the last of FRAMES against REFERENCE
//                                          samples, for a camera that stands and one that goes
//                                          round the figure. The time is that of a film of 24
//                                          frames, drawn as those of a film are, two in flight,
//                                          skinning included; what persists was made before
//   peer_scene draw FRAMES SAMPLES standing|moving
//                                          draws it on one thread and prints processor seconds a
//                                          frame: for profilers, and to hold two builds side by
//                                          side
//   peer_scene picture FRAME SAMPLES standing|moving|close matte|sheen FILE [LEFT TOP WIDTH HEIGHT]
//                                          draws one frame, or a part of it, and writes its beauty,
//                                          albedo, normals and positions, one film after the other,
//                                          as 32-bit floats, the first row at the top; matte leaves
//                                          out the specular lobe of materials

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "peers/walking_mannequin.h"
#include "peers/walking_scene.h"

namespace {

using namespace mien;
using namespace mien::peers;
using nlohmann::json;

/// The scene of a frame, 0 … frames_in_all − 1.
using SceneAt = std::function<render::Scene(int frame)>;

const std::map<std::string, View> views = {
    {"standing", View::standing}, {"moving", View::moving}, {"close", View::close}};

json numbers(const render::Vec3& v) { return {v.x(), v.y(), v.z()}; }

json numbers(const Color& c) { return {c.x(), c.y(), c.z()}; }

json sticks_of(const motion::Clip& clip) {
  json sticks;
  sticks["joint_radius"] = joint_radius;
  sticks["bone_radius"] = bone_radius;
  sticks["albedo"] = {0.2, 0.35, 0.6};
  sticks["parents"] = joints_at(clip, 0).parents;
  for (int f = 0; f < frames_in_all; ++f) {
    json joints;
    for (const render::Vec3& place : joints_at(clip, f).places) joints.push_back(numbers(place));
    sticks["joints"].push_back(joints);
  }
  return sticks;
}

void write_vectors(std::ostream& out, const std::vector<render::Vec3>& vectors) {
  for (const render::Vec3& v : vectors)
    out.write(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
}

/// The scene's mesh, whose vertices are written to a file beside.
json mesh_of(const SceneAt& scene_at, const std::string& vertex_file) {
  const render::Scene scene = scene_at(0);
  const render::Mesh& mesh = scene.solids.meshes[0];
  const render::Material& skin = scene.materials[static_cast<std::size_t>(mesh.material)];
  const render::Texture& paint = *scene.textures[static_cast<std::size_t>(skin.texture)];
  json texels;
  for (const Color& texel : paint.texels) texels.push_back(numbers(Color(skin.albedo * texel)));
  std::ofstream vertices(vertex_file, std::ios::binary);
  for (int f = 0; f < frames_in_all; ++f) {
    const render::Scene moved = scene_at(f);
    write_vectors(vertices, moved.solids.meshes[0].positions);
    write_vectors(vertices, moved.solids.meshes[0].normals);
  }
  return {{"vertices", mesh.positions.size()},
          {"triangles", mesh.triangles},
          {"uv", mesh.uv},
          {"specular_f0", skin.specular_f0},
          {"roughness", skin.roughness},
          {"paint", {{"width", paint.width}, {"height", paint.height}, {"texels", texels}}}};
}

void write_scene(const motion::Clip& clip, const SceneAt& scene_at, const std::string& file) {
  json out;
  const render::Scene scene = scene_at(0);
  const render::AreaLight& light = scene.lights[0];
  out["floor_albedo"] = 0.5;
  out["sky"] = 0.6;
  out["light"] = {{"centre", numbers(light.centre)},
                  {"half_u", numbers(light.half_u)},
                  {"half_v", numbers(light.half_v)},
                  {"radiance", light.radiance.x()}};
  out["vertical_field_of_view"] = camera_at(0, View::standing).vertical_field_of_view;
  for (const auto& [name, view] : views) {
    for (int f = 0; f < frames_in_all; ++f) {
      const render::Camera camera = camera_at(f, view);
      out["cameras"][name].push_back(
          {{"position", numbers(camera.position)}, {"target", numbers(camera.target)}});
    }
  }
  if (scene.solids.meshes.empty()) {
    out["sticks"] = sticks_of(clip);
  } else {
    out["mesh"] = mesh_of(scene_at, file + ".vertices");
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
render::Framebuffer draw_frames(render::Tracer& tracer, const SceneAt& scene_at, View view,
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
    const render::Camera camera = camera_at(f, view);
    if (flight(number).film.channels.empty())
      flight(number).film = render::Framebuffer(camera.width, camera.height);
    flight(number).ready = tracer.prepare({scene_at(f), camera, quality});
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

json measure(const SceneAt& scene_at, View view, int frames, int reference_samples,
             const std::vector<int>& counts) {
  render::Tracer tracer;
  // Against plain sampling: every ray of its own, nothing interpolated.
  render::Quality thorough = quality_of(reference_samples);
  thorough.floor_sky_tolerance = 0.0f;
  thorough.seed = 1234567;
  const int last = frames - 1;
  const render::Scene shown = scene_at(last);
  const render::Framebuffer reference = tracer.trace(shown, camera_at(last, view), thorough);
  json rows;
  for (const int samples : counts) {
    render::Tracer fresh;
    const render::Framebuffer film =
        draw_frames(fresh, scene_at, view, frames, quality_of(samples));
    const auto start = std::chrono::steady_clock::now();
    draw_frames(fresh, scene_at, view, timed_frames, quality_of(samples));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    rows.push_back({{"samples", samples},
                    {"seconds", taken.count() / timed_frames},
                    {"error", rms(film, reference)}});
  }
  return rows;
}

/// Processor seconds a frame, after a first one that shows the set.
double drawing_seconds(const SceneAt& scene_at, View view, int frames, int samples) {
  render::Tracer tracer({.threads = 1});
  const auto draw = [&](int f) {
    tracer.trace(scene_at(f), camera_at(f, view), quality_of(samples));
  };
  draw(0);
  const std::clock_t start = std::clock();
  for (int f = 0; f < frames; ++f) draw(f);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / frames;
}

void write_picture(render::Scene scene, const render::Camera& camera, int samples, bool matte,
                   const std::string& file) {
  render::Quality quality = quality_of(samples);
  quality.floor_sky_tolerance = 0.0f;
  for (render::Material& material : scene.materials)
    if (matte) material.specular_f0 = 0.0f;
  const render::Layers layers = render::Tracer().layers(scene, camera, quality);
  std::ofstream out(file, std::ios::binary);
  for (const render::Framebuffer* film :
       {&layers.beauty, &layers.albedo, &layers.normal, &layers.position}) {
    out.write(reinterpret_cast<const char*>(film->channels.data()),
              static_cast<std::streamsize>(film->channels.size() * sizeof(float)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Walk clip = walk();
  SceneAt scene_at = [&](int frame) { return scene_of(joints_at(clip, frame)); };
  std::unique_ptr<const WalkingMannequin> mannequin;
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool is_flat = !words.empty() && words[0] == "--figure=flat-mannequin";
  if (is_flat || (!words.empty() && words[0] == "--figure=mannequin")) {
    words.erase(words.begin());
    mannequin =
        std::make_unique<const WalkingMannequin>(clip, is_flat ? Shading::flat : Shading::smooth);
    scene_at = [&](int frame) { return mannequin->scene_at(frame); };
  }
  const std::string what = words.empty() ? "" : words[0];
  const auto number = [&](std::size_t i) { return std::atoi(words[i].c_str()); };
  const auto is_view = [&](std::size_t i) { return views.contains(words[i]); };
  if (what == "write" && words.size() == 2) {
    write_scene(clip, scene_at, words[1]);
    return 0;
  }
  if (what == "measure" && words.size() >= 3) {
    const int frames = number(1), reference = number(2);
    if (frames < 1 || frames > frames_in_all || reference < 1) return 2;
    std::vector<int> counts;
    for (std::size_t i = 3; i < words.size(); ++i) counts.push_back(std::max(number(i), 2));
    if (counts.empty()) counts = {2, 4, 8, 16, 32, 64};
    std::cout << json{{"standing", measure(scene_at, View::standing, frames, reference, counts)},
                      {"moving", measure(scene_at, View::moving, frames, reference, counts)}}
              << '\n';
    return 0;
  }
  if (what == "draw" && words.size() == 4 && is_view(3)) {
    const int frames = number(1), samples = number(2);
    if (frames < 1 || frames > frames_in_all || samples < 2) return 2;
    std::cout << drawing_seconds(scene_at, views.at(words[3]), frames, samples) << '\n';
    return 0;
  }
  if (what == "picture" && (words.size() == 6 || words.size() == 10) && is_view(3) &&
      (words[4] == "matte" || words[4] == "sheen")) {
    const int frame = number(1), samples = number(2);
    if (frame < 0 || frame >= frames_in_all || samples < 1) return 2;
    render::Camera camera = camera_at(frame, views.at(words[3]));
    if (words.size() == 10)
      camera.window = render::Window{number(6), number(7), number(8), number(9)};
    write_picture(scene_at(frame), camera, samples, words[4] == "matte", words[5]);
    return 0;
  }
  std::cerr << "peer_scene [--figure=[flat-]mannequin] write SCENE.json | measure FRAMES REFERENCE "
               "[SAMPLES…] | draw FRAMES SAMPLES standing|moving | "
               "picture FRAME SAMPLES standing|moving|close matte|sheen FILE "
               "[LEFT TOP WIDTH HEIGHT]\n";
  return 2;
}
