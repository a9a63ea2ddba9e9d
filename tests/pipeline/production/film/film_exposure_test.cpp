#include "pipeline/production/film/film_exposure.h"

#include <gtest/gtest.h>

#include "render/image/luminance.h"

namespace mien::pipeline {
namespace {

render::Framebuffer ramp(float most) {
  render::Framebuffer film(64, 16);
  for (std::size_t i = 0; i < film.channels.size(); ++i) {
    film.channels[i] = most * static_cast<float>(i) / static_cast<float>(film.channels.size());
  }
  return film;
}

TEST(FilmExposure, BringsFilmsToTheLuminanceWanted) {
  for (const float most : {0.05f, 0.4f, 3.0f}) {
    const std::vector<render::Framebuffer> films = {ramp(most), ramp(0.5f * most)};
    for (const double wanted : {0.05, 0.2, 0.45}) {
      const render::Tone tone{.exposure_stops = stops_for(films, {}, wanted)};
      const double mean = 0.5 * (render::luminance_of(render::to_srgb8(films[0], tone)).mean +
                                 render::luminance_of(render::to_srgb8(films[1], tone)).mean);
      EXPECT_NEAR(mean, wanted, 0.002 * wanted + 1e-4) << most;
    }
  }
}

TEST(FilmExposure, LeavesAloneWhatIsRightAndStopsAtTheEnds) {
  const std::vector<render::Framebuffer> films = {ramp(0.6f)};
  EXPECT_NEAR(stops_for(films, {}, render::mean_luminance(films[0], {})), 0.0, 1e-4);
  EXPECT_NEAR(stops_for(films, {}, 1.0), 8.0, 1e-3);
  EXPECT_NEAR(stops_for({ramp(0.0f)}, {}, 0.2), 8.0, 1e-3);
}

}  // namespace
}  // namespace mien::pipeline
