#include "render/tracer/static_background_cache.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "render/tracer/tracer.h"

namespace mien::render {
namespace {

StaticBackground dark_set() { return blank_background(4, 2, frame_of({.width = 4, .height = 2})); }

TEST(StaticBackgroundCache, MakesABackgroundOnceForAllThatUseItAtATime) {
  StaticBackgroundCache sets;
  std::atomic<int> made = 0;
  std::atomic<int> asked = 0;
  constexpr int threads = 4;
  const auto make = [&] {
    ++made;
    while (asked < threads) std::this_thread::yield();  // all others ask meanwhile
    return dark_set();
  };
  std::vector<StaticBackgroundCache::Handle> lent(threads);
  std::vector<std::thread> asking;
  for (StaticBackgroundCache::Handle& one : lent) {
    asking.emplace_back([&] {
      ++asked;
      one = sets.get_or_make("a", make);
    });
  }
  for (std::thread& thread : asking) thread.join();
  EXPECT_EQ(made, 1);
  for (const StaticBackgroundCache::Handle& one : lent) EXPECT_EQ(one, lent[0]);
  EXPECT_NE(sets.get_or_make("b", dark_set), lent[0]);

  lent.clear();
  sets.get_or_make("a", make);
  EXPECT_EQ(made, 2) << "one that nobody draws with any more takes no memory";
}

TEST(StaticBackgroundCache, IsFilledByTheNextWhereMakingOneFailed) {
  StaticBackgroundCache sets;
  const auto fail = []() -> StaticBackground { throw std::runtime_error("stopped"); };
  EXPECT_THROW(sets.get_or_make("a", fail), std::runtime_error);
  EXPECT_NE(sets.get_or_make("a", dark_set), nullptr);
}

/// A ball on the floor before a wall that stands.
Scene walled() {
  Scene scene;
  scene.materials = {{.albedo = {0.6f, 0.5f, 0.4f}}};
  scene.solids.spheres = {{.centre = {0.0f, 0.5f, 0.0f}, .radius = 0.4f}};
  Mesh wall;
  wall.positions = {
      {-2.0f, 0.0f, -1.0f}, {2.0f, 0.0f, -1.0f}, {2.0f, 1.5f, -1.0f}, {-2.0f, 1.5f, -1.0f}};
  wall.normals.assign(4, Vec3::UnitZ());
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.static_solids.meshes = {wall};
  scene.lights = {
      softbox({1.5f, 3.0f, 3.0f}, {0.0f, 0.8f, 0.0f}, 0.8f, 0.8f, Color::Constant(9.0f))};
  return scene;
}

const Camera viewer{
    .position = {0.8f, 1.5f, 4.0f}, .target = {0.0f, 0.7f, 0.0f}, .width = 48, .height = 32};
const Quality coarse{.samples_per_pixel = 4, .static_samples = 8, .seed = 5};

TEST(StaticBackgroundCache, ChangesNoPicture) {
  const Scene scene = walled();
  const Framebuffer alone = Tracer({.threads = 1}).trace(scene, viewer, coarse);
  StaticBackgroundCache sets;
  Tracer first({.threads = 1, .backgrounds = &sets}), second({.threads = 2, .backgrounds = &sets});
  EXPECT_EQ(first.trace(scene, viewer, coarse), alone);
  EXPECT_EQ(second.trace(scene, viewer, coarse), alone);

  // Of another seed, another camera or a camera out of focus.
  Quality other = coarse;
  other.seed = 6;
  EXPECT_EQ(second.trace(scene, viewer, other), Tracer().trace(scene, viewer, other));
  Camera wide = viewer;
  wide.aperture_radius = 0.05f;
  wide.focus_distance = 3.0f;
  EXPECT_EQ(second.trace(scene, wide, coarse), Tracer().trace(scene, wide, coarse));
}

TEST(StaticBackgroundCache, NamesLightByAllThatDecidesIt) {
  std::vector<std::string> names;
  Framebuffer kept;
  const LightCache keep = [&](const std::string& name, const std::function<Framebuffer()>& draw) {
    names.push_back(name);
    return kept.channels.empty() ? kept = draw() : kept;
  };
  const Scene scene = walled();
  const auto traced = [&](const Scene& of, const Camera& by, const Quality& how) {
    return Tracer({.light_cache = keep}).trace(of, by, how);
  };
  const Framebuffer drawn = traced(scene, viewer, coarse);
  EXPECT_EQ(drawn, Tracer().trace(scene, viewer, coarse));
  EXPECT_EQ(traced(scene, viewer, coarse), drawn);
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[0], names[1]);
  EXPECT_EQ(names[0].size(), 32u);

  const auto name_of = [&](const Scene& of, const Camera& by, const Quality& how) {
    return static_background_name(static_background_key(of, by, how));
  };
  Scene figure_moved = scene;
  figure_moved.solids.spheres[0].centre.x() += 0.2f;
  EXPECT_EQ(name_of(figure_moved, viewer, coarse), names[0]);
  Scene figure_painted = scene;
  figure_painted.materials = {{.albedo = {0.1f, 0.9f, 0.1f}}, scene.materials[0]};
  figure_painted.static_solids.meshes[0].material = 1;
  EXPECT_EQ(name_of(figure_painted, viewer, coarse), names[0]);
  Scene wall_painted = scene;
  wall_painted.materials[0].albedo[0] += 0.1f;
  EXPECT_NE(name_of(wall_painted, viewer, coarse), names[0]);
  Scene wall_moved = scene;
  wall_moved.static_solids.meshes[0].positions[0].x() += 0.2f;
  EXPECT_NE(name_of(wall_moved, viewer, coarse), names[0]);
  Camera moved = viewer;
  moved.position.x() += 1e-3f;
  EXPECT_NE(name_of(scene, moved, coarse), names[0]);
  Quality thorough = coarse;
  thorough.static_samples = 9;
  EXPECT_NE(name_of(scene, viewer, thorough), names[0]);

  // Without standing solids nothing is worth keeping.
  Scene open = scene;
  open.static_solids = {};
  traced(open, viewer, coarse);
  EXPECT_EQ(names.size(), 2u);
}

}  // namespace
}  // namespace mien::render
