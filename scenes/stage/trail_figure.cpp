#include "scenes/stage/trail_figure.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double least_trace_step_m = 0.012;

float faded(const TrailOptions& options, double share) {
  return static_cast<float>(options.min_opacity + (1.0 - options.min_opacity) * share);
}

/// Joints by the words of a manifest.
std::vector<std::string> joints_of(const std::string& word) {
  if (word == "feet") return {"LeftAnkle", "RightAnkle"};
  if (word == "hands") return {"LeftWrist", "RightWrist"};
  if (word == "head") return {"Head"};
  if (word == "pelvis") return {"Pelvis"};
  return {word};
}

std::vector<std::string> traced_joints(const std::vector<std::string>& words) {
  std::vector<std::string> joints;
  for (const std::string& word : words) {
    for (const std::string& joint : joints_of(word)) joints.push_back(joint);
  }
  return joints;
}

const render::Color& colour_of(std::string_view joint, const FigureColours& colours) {
  if (joint.starts_with("Left")) return colours.left;
  return joint.starts_with("Right") ? colours.right : colours.middle;
}

/// A thin tube along the path up to a frame.
void add_tube(render::Scene& scene, const DotPath& path, int frame, double width, int material) {
  const auto radius = static_cast<float>(0.5 * width);
  render::Vec3 from = path.front().cast<float>();
  for (int f = 1; f <= frame; ++f) {
    const render::Vec3 to = path[static_cast<std::size_t>(f)].cast<float>();
    if (f < frame && (to - from).norm() < static_cast<float>(least_trace_step_m)) continue;
    scene.solids.round_cones.push_back({from, to, radius, radius, material});
    from = to;
  }
}

void add_traces(render::Scene& scene, const Actor& actor, const TrailOptions& options, int frame) {
  for (const Dot& dot : actor.traces) {
    const auto material = static_cast<int>(scene.materials.size());
    scene.materials.push_back({colour_of(dot.kind, actor.colours), 0.03f, 0.55f});
    add_tube(scene, dot.path, frame, options.trace_width_m, material);
  }
}

}  // namespace

std::vector<Ghost> ghosts_at(const TrailOptions& options, int frame, int frame_count,
                             double frames_per_second) {
  std::vector<Ghost> ghosts;
  for (int k = 0; k < options.poses; ++k) {
    const int left = static_cast<int>(std::lround(1.0 * k * (frame_count - 1) / options.poses));
    if (left >= frame) break;
    const double age = 1.0 * (frame - left) / std::max(frame_count - 1, 1);
    ghosts.push_back({left, faded(options, 1.0 - age)});
  }
  for (int k = std::max(options.before, options.after); k >= 1; --k) {
    const int away = static_cast<int>(std::lround(k * options.every_s * frames_per_second));
    const auto share = [&](int most) { return 1.0 - 1.0 * k / (most + 1); };
    if (k <= options.before && frame - away >= 0) {
      ghosts.push_back({frame - away, faded(options, share(options.before))});
    }
    if (k <= options.after && frame + away < frame_count) {
      ghosts.push_back({frame + away, faded(options, share(options.after))});
    }
  }
  // A pose is shown once.
  std::set<int> shown = {frame};
  std::erase_if(ghosts, [&](const Ghost& ghost) { return !shown.insert(ghost.frame).second; });
  return ghosts;
}

int max_ghosts(const TrailOptions& options) {
  return options.poses + options.before + options.after;
}

std::vector<Dot> traces_of(const motion::Clip& clip, const TrailOptions& options) {
  if (options.traces.empty()) return {};
  PointLightOptions traced;
  traced.joint_set.clear();
  traced.joints = traced_joints(options.traces);
  return point_light(clip, traced, {});
}

void add_trail(render::Scene& scene, const Actor& actor, const TrailOptions& options, int frame,
               int made_at, const render::Camera& camera) {
  const auto draw = [&](const std::string& name, float opacity, int at) {
    draw_as_figure(scene, name, opacity * actor.opacity,
                   [&] { actor.draw(scene, actor, at, camera); });
  };
  draw(actor.name, 1.0f, frame);
  int number = 0;
  for (const Ghost& ghost :
       ghosts_at(options, made_at, actor.clip.frame_count(), actor.clip.frames_per_second)) {
    draw(actor.name + "-ghost-" + std::to_string(++number), ghost.opacity, ghost.frame);
  }
  if (actor.traces.empty()) return;
  draw_as_figure(scene, actor.name + "-traces", actor.opacity,
                 [&] { add_traces(scene, actor, options, made_at); });
}

}  // namespace mien::scenes
