#include "pipeline/production/film/frame_drawer.h"

#include <algorithm>
#include <utility>

#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

constexpr int most_in_flight = 4;

/// The frame towards which a shutter opens: the next one, and from the last back to the one before.
int frame_after(const scenes::Shot& shot, int frame) {
  return frame + 1 < shot.frame_count() ? frame + 1 : std::max(frame - 1, 0);
}

/// Two pictures of the same height as one.
render::Framebuffer beside(const render::Framebuffer& left, const render::Framebuffer& right) {
  render::Framebuffer both(left.width + right.width, left.height);
  for (int y = 0; y < both.height; ++y) {
    std::copy_n(left.at(0, y), 3 * left.width, both.at(0, y));
    std::copy_n(right.at(0, y), 3 * right.width, both.at(left.width, y));
  }
  return both;
}

}  // namespace

FrameDrawer::FrameDrawer(const scenes::Shot& shot, const FilmSettings& settings, FrameFormat kept,
                         const std::stop_token& stop)
    : shot_(shot),
      kept_(kept),
      layers_(settings.output.frames == FrameFormat::layers),
      eyes_(static_cast<int>(cameras_at(shot, 0).size())),
      quality_(quality_of(settings, shot)),
      tracer_(tracer_options(settings, shot, stop)) {}

// One more than there are threads: what is drawn before the frame ahead of it ends waits for that.
// The layers of a frame take ten times the memory of others, and have pictures of their own.
int FrameDrawer::in_flight() const {
  const int threads = tracer_.threads();
  return layers_ || threads == 1 ? 1 : std::min(threads + 1, most_in_flight);
}

ReadyFrame FrameDrawer::prepare(int frame) {
  ReadyFrame ready{frame, {}};
  for (int eye = 0; eye < eyes_ && !layers_; ++eye)
    ready.prepared_views.push_back(tracer_.prepare(view_of(frame, eye)));
  return ready;
}

FramePicture FrameDrawer::draw(ReadyFrame ready) {
  if (layers_) return draw_layers(ready.frame);
  if (kept_ == FrameFormat::exr) return draw_light(std::move(ready));
  if (kept_ == FrameFormat::png16) return draw_picture<render::Image16>(std::move(ready));
  return draw_picture<render::Image8>(std::move(ready));
}

FramePicture FrameDrawer::draw_layers(int frame) {
  render::Layers layers = layers_of(tracer_, shot_, frame, quality_);
  if (kept_ == FrameFormat::none) return render::to_srgb8(layers.beauty, shot_.tone);
  return layers;
}

render::Framebuffer FrameDrawer::draw_light(ReadyFrame ready) {
  std::vector<render::Framebuffer> eye_pictures;
  for (render::PreparedView& prepared_view : ready.prepared_views)
    eye_pictures.push_back(tracer_.draw(std::move(prepared_view)).color);
  return eyes_ == 1 ? std::move(eye_pictures[0]) : beside(eye_pictures[0], eye_pictures[1]);
}

template <class Picture>
Picture FrameDrawer::draw_picture(ReadyFrame ready) {
  const render::Window window = window_of(cameras_at(shot_, ready.frame)[0]);
  Picture picture(eyes_ * window.width, window.height);
  int left = 0;
  for (render::PreparedView& prepared_view : ready.prepared_views) {
    tracer_.draw(std::move(prepared_view), [&](const render::RenderedRegion& part) {
      develop(part.framebuffer, part.pixels, shot_.tone, picture, left + part.x, part.y);
    });
    left += window.width;
  }
  return picture;
}

render::View FrameDrawer::view_of(int frame, int eye) const {
  const auto camera_at_frame = [&](int at) {
    return cameras_at(shot_, at)[static_cast<std::size_t>(eye)];
  };
  render::View view{scene_at(shot_, frame), camera_at_frame(frame), quality_};
  if (quality_.shutter <= 0.0f) return view;
  const int closing = frame_after(shot_, frame);
  view.closing = scene_at(shot_, closing, frame);
  if (shot_.cameras.cameras.size() > 1) view.closing_camera = camera_at_frame(closing);
  return view;
}

}  // namespace mien::pipeline
