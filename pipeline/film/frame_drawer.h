#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "pipeline/film/film.h"
#include "pipeline/film/film_frames.h"
#include "render/tracer/tracer.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// Draws frames of a shot. While one is drawn the one after is made ready, and each part of a
/// picture is developed by the thread that drew it. The shot and the settings outlive it.
class FrameDrawer {
 public:
  /// `kept` is the form in which frames are wanted. Throws as the tracer does.
  FrameDrawer(const scenes::Shot& shot, const FilmSettings& settings, FrameFormat kept,
              const std::stop_token& stop);

  /// A frame in that form; `next` is the one that will be asked for after it, if any. Throws
  /// render::Stopped when it was given up because of a stop request.
  FramePicture draw(int frame, std::optional<int> next);

 private:
  /// What one eye sees of a frame.
  struct Sight {
    int frame;
    int eye;
    friend bool operator==(const Sight&, const Sight&) = default;
  };
  using Drawn = std::function<void(int eye, const render::Film& film, const render::Window& part)>;

  FramePicture draw_layers(int frame);
  render::Film draw_light(int frame, std::optional<int> next);
  template <class Picture>
  Picture draw_picture(int frame, std::optional<int> next);
  /// Over the film of the sight before.
  void draw_sight(const Sight& sight, std::optional<Sight> next, const Drawn& drawn);
  std::optional<Sight> after(const Sight& sight, std::optional<int> next_frame) const;
  render::View view_of(const Sight& sight) const;

  const scenes::Shot& shot_;
  const FilmSettings& settings_;
  FrameFormat kept_;
  int eyes_;
  render::Quality quality_;
  render::Tracer tracer_;
  std::optional<Sight> waiting_;  // what is ready
  render::ReadyPicture ready_;
  render::Film film_;
};

}  // namespace mien::pipeline
