#include "scenes/point_light/dot_display.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/image/tone.h"
#include "render/tracer/tracer.h"

namespace mien::scenes {
namespace {

/// Dots that stand still, before a camera that looks at the origin from +Z.
std::vector<Dot> dots_at(const std::vector<motion::Vec3>& places) {
  std::vector<Dot> dots;
  for (const motion::Vec3& place : places) dots.push_back({"dot", {place}});
  return dots;
}

render::Camera camera() {
  render::Camera camera;
  camera.position = {0.0f, 1.0f, 6.0f};
  camera.target = {0.0f, 1.0f, 0.0f};
  camera.width = 320;
  camera.height = 180;
  return camera;
}

render::Framebuffer picture(const std::vector<Dot>& dots, const PointLightOptions& options,
                            const render::Camera& from) {
  render::Scene scene;
  scene.has_ground = false;
  const render::Color background = dot_colours(options).background;
  scene.sky.backdrop_horizon = scene.sky.backdrop_zenith = background;
  render::AreaLight light;
  scene.lights.push_back(light);
  add_dots(scene, dots, 0, options, from);
  render::Quality quality = render::standard_quality();
  quality.samples_per_pixel = 64;
  return render::Tracer({.threads = 1}).trace(scene, from, quality);
}

/// Diameter of the one disc in a white-on-black picture, by its area.
double diameter_in(const render::Framebuffer& film) {
  double area = 0.0;
  for (std::size_t i = 0; i < film.channels.size(); i += 3) {
    area += static_cast<double>(film.channels[i]);
  }
  return 2.0 * std::sqrt(area / motion::pi);
}

TEST(DotDisplay, DotsHaveTheStatedDiameterNearFarAndAtTheEdge) {
  PointLightOptions options;
  for (const double diameter : {5.0, 8.0, 13.5}) {
    options.size_px = diameter;
    for (const motion::Vec3& place :
         {motion::Vec3(0, 1, 0), motion::Vec3(0.3, 1.2, 3), motion::Vec3(-1.9, 0.2, -0.5)}) {
      const render::Framebuffer film = picture(dots_at({place}), options, camera());
      EXPECT_NEAR(diameter_in(film), diameter, 0.1) << place.transpose();
    }
  }
}

TEST(DotDisplay, AnOrthographicCameraSeesThemAsLarge) {
  render::Camera parallel = camera();
  parallel.parallel_height = 2.5f;
  PointLightOptions options;
  const render::Framebuffer film = picture(dots_at({{0.2, 1.1, -1.0}}), options, parallel);
  EXPECT_NEAR(diameter_in(film), 8.0, 0.1);
}

TEST(DotDisplay, ADiameterInMetresLooksSmallerFromAfar) {
  PointLightOptions options;
  options.size_m = 0.2;
  const double near = diameter_in(picture(dots_at({{0, 1, 3}}), options, camera()));
  const double far = diameter_in(picture(dots_at({{0, 1, 0}}), options, camera()));
  EXPECT_NEAR(near / far, 2.0, 0.03);
}

TEST(DotDisplay, ColoursAreExactAndTheEdgesAreSmooth) {
  PointLightOptions options;
  options.size_px = 20.0;
  options.colour = "#c86432";
  options.background = "#405060";
  render::Tone tone;
  tone.shoulder = 1.0f;
  const render::Image8 image =
      render::to_srgb8(picture(dots_at({{0, 1, 0}}), options, camera()), tone);
  const auto pixel = [&](int x, int y) {
    return std::array<int, 3>{image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]};
  };
  EXPECT_EQ(pixel(160, 90), (std::array<int, 3>{0xc8, 0x64, 0x32}));
  EXPECT_EQ(pixel(5, 5), (std::array<int, 3>{0x40, 0x50, 0x60}));
  int between = 0;
  for (int x = 140; x < 180; ++x) between += pixel(x, 90)[0] > 0x44 && pixel(x, 90)[0] < 0xc4;
  EXPECT_GE(between, 2);
}

TEST(DotDisplay, ContrastIsMichelsons) {
  for (const double contrast : {0.0, 0.3, 1.0}) {
    PointLightOptions options;
    options.contrast = contrast;
    for (const bool dark : {false, true}) {
      options.dark_on_light = dark;
      const DotColours colours = dot_colours(options);
      const double dots = static_cast<double>(colours.dots[1]);
      const double background = static_cast<double>(colours.background[1]);
      EXPECT_NEAR(std::abs(dots - background) / (dots + background), contrast, 1e-6);
      EXPECT_EQ(std::max(dots, background), 1.0);
      if (contrast > 0.0) {
        EXPECT_EQ(dots < background, dark);
      }
    }
  }
}

}  // namespace
}  // namespace mien::scenes
