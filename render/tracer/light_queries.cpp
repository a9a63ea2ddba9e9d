#include "render/tracer/light_queries.h"

namespace mien::render {

void LightQueries::trace() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = picture_.figure.occluded(rays_);
  const std::uint32_t by_set = picture_.walls ? picture_.walls->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const bool figure = ((by_figure >> i) & 1u) != 0, set = ((by_set >> i) & 1u) != 0;
    switch (query.effect) {
      case Effect::arrives_at_figure:
        if (!figure && !set) add_light(query.sample, &Pixel::figure, query.light);
        break;
      case Effect::arrives_at_set:
        if (!figure && !set) add_light(query.sample, &Pixel::set, query.light);
        break;
      case Effect::taken_from_figure:
        if (figure || set) add_light(query.sample, &Pixel::figure, -query.light);
        break;
      case Effect::taken_from_set:
        if (figure || set) add_light(query.sample, &Pixel::set, -query.light);
        break;
      case Effect::taken_when_figure_blocks:
        if (figure && !set) add_light(query.sample, &Pixel::taken, -query.light);
        break;
      case Effect::taken_when_blocked:
        if (figure || set) add_light(query.sample, &Pixel::taken, -query.light);
        break;
    }
  }
  rays_.count = 0;
}

}  // namespace mien::render
