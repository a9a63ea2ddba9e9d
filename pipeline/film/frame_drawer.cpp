#include "pipeline/film/frame_drawer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

/// The frame towards which a shutter opens: the next one, and from the last back to the one before.
int frame_after(const scenes::Shot& shot, int frame) {
  return frame + 1 < shot.frame_count() ? frame + 1 : std::max(frame - 1, 0);
}

/// Two pictures of the same height as one.
render::Film beside(const render::Film& left, const render::Film& right) {
  render::Film both(left.width + right.width, left.height);
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
      settings_(settings),
      kept_(kept),
      eyes_(static_cast<int>(cameras_at(shot, 0).size())),
      quality_(quality_of(settings, shot)),
      tracer_(tracer_options(settings, shot, stop)) {}

FramePicture FrameDrawer::draw(int frame, std::optional<int> next) {
  if (settings_.output.frames == FrameFormat::layers) return draw_layers(frame);
  if (kept_ == FrameFormat::exr) return draw_light(frame, next);
  if (kept_ == FrameFormat::png16) return draw_picture<render::Image16>(frame, next);
  return draw_picture<render::Image8>(frame, next);
}

FramePicture FrameDrawer::draw_layers(int frame) {
  render::Layers layers = layers_of(tracer_, shot_, frame, quality_);
  if (kept_ == FrameFormat::none) return render::to_srgb8(layers.beauty, shot_.tone);
  return layers;
}

render::Film FrameDrawer::draw_light(int frame, std::optional<int> next) {
  std::vector<render::Film> seen;
  for (Sight sight{frame, 0}; sight.eye < eyes_; ++sight.eye) {
    draw_sight(sight, after(sight, next), {});
    seen.push_back(std::move(film_));
  }
  return eyes_ == 1 ? std::move(seen[0]) : beside(seen[0], seen[1]);
}

template <class Picture>
Picture FrameDrawer::draw_picture(int frame, std::optional<int> next) {
  const render::Window window = window_of(cameras_at(shot_, frame)[0]);
  Picture picture(eyes_ * window.width, window.height);
  const Drawn drawn = [&](int eye, const render::Film& film, const render::Window& part) {
    develop(film, part, shot_.tone, picture, eye * window.width + part.x - window.x,
            part.y - window.y);
  };
  for (Sight sight{frame, 0}; sight.eye < eyes_; ++sight.eye)
    draw_sight(sight, after(sight, next), drawn);
  return picture;
}

void FrameDrawer::draw_sight(const Sight& sight, std::optional<Sight> next, const Drawn& drawn) {
  render::ReadyPicture now =
      waiting_ == sight ? std::move(ready_) : tracer_.prepare(view_of(sight));
  waiting_.reset();
  render::Alongside alongside;
  if (next)
    alongside.meanwhile = [&] {
      ready_ = tracer_.prepare(view_of(*next));
      waiting_ = next;
    };
  if (drawn) alongside.drawn = std::bind_front(drawn, sight.eye);
  film_ = tracer_.draw(std::move(now), std::move(film_), alongside).film;
}

std::optional<FrameDrawer::Sight> FrameDrawer::after(const Sight& sight,
                                                     std::optional<int> next_frame) const {
  if (sight.eye + 1 < eyes_) return Sight{sight.frame, sight.eye + 1};
  if (next_frame) return Sight{*next_frame, 0};
  return std::nullopt;
}

render::View FrameDrawer::view_of(const Sight& sight) const {
  const auto camera_at_frame = [&](int frame) {
    return cameras_at(shot_, frame)[static_cast<std::size_t>(sight.eye)];
  };
  render::View view{scene_at(shot_, sight.frame), camera_at_frame(sight.frame), quality_};
  if (quality_.shutter <= 0.0f) return view;
  const int closing = frame_after(shot_, sight.frame);
  view.closing = scene_at(shot_, closing, sight.frame);
  if (shot_.cameras.cameras.size() > 1) view.closing_camera = camera_at_frame(closing);
  return view;
}

}  // namespace mien::pipeline
