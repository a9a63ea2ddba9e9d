#include "render/tracer/tracer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "render/image/luminance.h"
#include "render/tracer/engine.h"
#include "render/tracer/layer_pass.h"
#include "render/tracer/samples.h"

namespace mien::render {

namespace {

void check(const Quality& quality) {
  if (quality.samples_per_pixel < 1 || quality.sky_rays < 1 || quality.static_samples < 1 ||
      !(quality.filter_width > 0.0f))
    throw std::invalid_argument("quality: samples, sky rays and filter width must be positive");
  constexpr int farthest = 64;  // pixels
  for (const int reach : {quality.figure_sharing_pixels, quality.floor_sharing_pixels})
    if (reach < 0 || reach > farthest || quality.figure_samples_per_ray < 1 ||
        quality.floor_samples_per_ray < 1)
      throw std::invalid_argument(
          "quality: occlusion can be shared within 0 to 64 pixels, with 1 or more samples per "
          "shared ray");
  if (quality.samples_shaded_together < 1 ||
      quality.samples_shaded_together > static_cast<int>(most_shaded_together))
    throw std::invalid_argument("quality: 1 to 4 samples can be shaded together");
  if (!(quality.shutter >= 0.0f && quality.shutter <= 1.0f))
    throw std::invalid_argument("quality: the shutter is not open for a share of 0 to 1");
}

Shapes shapes_of(const View& view) {
  return view.closing ? shapes_between(view.scene, *view.closing) : figure_shapes(view.scene);
}

}  // namespace

// The picture refers to the rest.
struct PreparedView::Contents {
  View view;
  SceneBackground background;
  PreparedScene prepared;

  Contents(Engine& engine, View shown)
      : view(std::move(shown)),
        background(engine.background_for(view.scene, view.camera, view.quality)),
        prepared(engine.prepare(view.scene, view.camera, view.quality, *background.image,
                                background.solids.get(), shapes_of(view), view.scene.solids)) {
    if (view.closing) prepared.closing_solids = &view.closing->solids;
    if (view.closing_camera) prepared.closing_camera = frame_of(*view.closing_camera);
    engine.sample_floor_sky(prepared);
    engine.find_shared_occlusion(prepared, view.camera);
  }
};

const PreparedView::Contents& Tracer::contents_of(const PreparedView& ready) {
  if (ready.contents_ == nullptr) throw std::logic_error("no picture is ready to be drawn");
  return *ready.contents_;
}

PreparedView::PreparedView() = default;
PreparedView::~PreparedView() = default;
PreparedView::PreparedView(PreparedView&&) noexcept = default;
PreparedView& PreparedView::operator=(PreparedView&&) noexcept = default;

Tracer::Tracer(const TracerOptions& options) : engine_(std::make_unique<Engine>(options)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

PreparedView Tracer::prepare(View view) {
  validate(view.scene);
  check(view.quality);
  if (view.closing) validate(*view.closing);
  PreparedView ready;
  ready.contents_ = std::make_unique<PreparedView::Contents>(*engine_, std::move(view));
  return ready;
}

RenderTarget Tracer::draw(PreparedView ready) {
  const PreparedView::Contents& contents = contents_of(ready);
  const View& view = contents.view;
  const PreparedScene& prepared = contents.prepared;
  const Camera& camera = view.camera;
  RenderTarget target{Framebuffer(camera.width, camera.height), {}};
  if (prepared.quality.background != Background::shown)
    target.alpha.resize(target.color.channels.size() / 3);
  engine_->for_all_parts(camera.width, camera.height, window_of(camera),
                         [&](const Window& part) { render::draw(prepared, part, {target}); });
  if (!camera.window) return target;
  target.color = crop(target.color, *camera.window);
  if (!target.alpha.empty()) target.alpha = crop(target.alpha, camera.width, *camera.window);
  return target;
}

void Tracer::draw(PreparedView ready, const OnRegion& take) {
  const PreparedView::Contents& contents = contents_of(ready);
  const View& view = contents.view;
  const PreparedScene& prepared = contents.prepared;
  if (prepared.quality.background != Background::shown)
    throw std::logic_error("only a picture whose background is shown is drawn part by part");
  const Window window = window_of(view.camera);
  engine_->for_all_parts(view.camera.width, view.camera.height, window, [&](const Window& part) {
    draw_pieces(prepared, part, [&](const Window& piece, const Framebuffer& framebuffer) {
      const Window shown = intersection(window, piece);
      take({framebuffer,
            {shown.x - piece.x, shown.y - piece.y, shown.width, shown.height},
            shown.x - window.x,
            shown.y - window.y});
    });
  });
}

void Tracer::for_frames(const FrameCallbacks& work, int in_flight) {
  engine_->for_frames(work, in_flight);
}

Framebuffer Tracer::trace(Scene scene, const Camera& camera, const Quality& quality) {
  View view{std::move(scene), camera, quality};
  view.quality.background = Background::shown;
  return draw(prepare(std::move(view))).color;
}

RenderTarget Tracer::render_view(View view) { return draw(prepare(std::move(view))); }

Layers Tracer::layers(const Scene& scene, const Camera& camera, const Quality& quality,
                      const Scene* next, const Camera* next_camera) {
  validate(scene);
  check(quality);
  if (next != nullptr) validate(*next);
  Camera sharp = camera;
  sharp.aperture_radius = 0.0f;
  Layers layers = empty_layers(scene, camera.width, camera.height);
  // In any quality, albedo and normals of the set are those of its background.
  Quality with_background = quality;
  with_background.reference = false;
  const SceneBackground background = engine_->background_for(scene, sharp, with_background);
  PreparedScene prepared =
      engine_->prepare(scene, sharp, quality, *background.image, background.solids.get(),
                       figure_shapes(scene), scene.solids);
  const Shapes later = next != nullptr ? figure_shapes(*next) : Shapes{};
  if (next != nullptr) {
    shapes_between(scene, *next);  // throws when they do not match
    prepared.next_shapes = &later;
  }
  const Camera* later_camera = next_camera == nullptr && next != nullptr ? &sharp : next_camera;
  engine_->for_all_parts(sharp.width, sharp.height, window_of(sharp), [&](const Window& part) {
    draw_layers(prepared, next, later_camera, part, layers);
  });
  if (sharp.window) layers = crop(std::move(layers), *sharp.window);
  layers.beauty = trace(scene, sharp, quality);
  add_variance(scene, sharp, quality, layers);
  return layers;
}

void Tracer::add_variance(const Scene& scene, const Camera& camera, Quality quality,
                          Layers& layers) {
  constexpr int pictures = 8;
  std::vector<double> sum(layers.variance.size()), squares(layers.variance.size());
  const std::uint64_t seed = quality.seed;
  for (int k = 0; k < pictures; ++k) {
    quality.seed = seed ^ (0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(k + 1));
    const Framebuffer framebuffer = trace(scene, camera, quality);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const Color pixel = Eigen::Map<const Color>(framebuffer.channels.data() + 3 * i);
      const auto light = static_cast<double>(relative_luminance(pixel));
      sum[i] += light;
      squares[i] += light * light;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / pictures;
    const double spread = squares[i] / pictures - mean * mean;
    // Below what rounding leaves of such a difference there is no noise.
    layers.variance[i] = spread > 1e-12 * mean * mean
                             ? static_cast<float>(spread * pictures / (pictures - 1))
                             : 0.0f;
  }
}

std::string Tracer::description() const { return engine_->device().description(); }

int Tracer::threads() const { return engine_->arena().max_concurrency(); }

}  // namespace mien::render
