#include "render/tracer/line_queries.h"

#include <bit>

namespace mien::render {

void LineQueries::ask(Pixel& pixel, const Vec3& point, std::uint32_t index, int samples) {
  pixels_[static_cast<std::size_t>(count_)] = &pixel;
  points_.set(count_, point);
  index_[count_] = index;
  samples_[count_] = static_cast<float>(samples);
  if (++count_ == static_cast<int>(lanes)) answer();
}

// Each query adds once to its pixel, in the order of asking, whatever waited beside it: so a
// pixel's light is always added up in the same order.
void LineQueries::answer() {
  taken_.fill(Color::Zero());
  std::uint32_t shaded = 0;
  for (int i = 0; i < count_; ++i) shaded |= pixels_[static_cast<std::size_t>(i)]->shadow_lights;
  for (shaded &= tile_.lights; shaded != 0; shaded &= shaded - 1)
    take_hidden(std::countr_zero(shaded));
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    pixels_[lane]->known_taken -= samples_[i] * taken_[lane] * pixels_[lane]->floor_albedo;
  }
  count_ = 0;
}

void LineQueries::take_hidden(int light) {
  const auto k = static_cast<std::size_t>(light);
  LaneWords seed;
  for (int i = 0; i < count_; ++i)
    seed[i] = pixels_[static_cast<std::size_t>(i)]->sampler.seed(Dimension::FirstLight, light);
  const LightLines lines =
      lines_across(picture_.scene.lights[k], points_, sample_points(index_, seed).u);
  for (std::vector<LinePart>& hidden : hidden_) hidden.clear();
  for (const int caster : tile_.casters[k]) {
    const RoundCone& cone = picture_.figure.shapes().cones[static_cast<std::size_t>(caster)];
    const LineParts parts = hidden_by(cone, points_, lines);
    for (int i = 0; i < count_; ++i)
      if (parts.first[i] < parts.last[i])
        hidden_[static_cast<std::size_t>(i)].push_back({parts.first[i], parts.last[i]});
  }
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    if (pixels_[lane]->may_lack(light))
      taken_[lane] += light_of_all(lines, i, hidden_[lane]) * picture_.scene.lights[k].radiance;
  }
}

}  // namespace mien::render
