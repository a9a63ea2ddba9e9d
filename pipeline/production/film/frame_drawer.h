#pragma once

#include <stop_token>
#include <vector>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_frames.h"
#include "render/tracer/tracer.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A frame that is ready to be drawn: what each eye sees of it.
struct ReadyFrame {
  int frame = 0;
  std::vector<render::PreparedView> prepared_views;
};

/// Draws frames of a shot, several at a time, and one is made ready meanwhile. Each part of a
/// picture is developed by the thread that drew it. The shot and the settings outlive it.
class FrameDrawer {
 public:
  /// `kept` is the form in which frames are wanted. Throws as the tracer does.
  FrameDrawer(const scenes::Shot& shot, const FilmSettings& settings, FrameFormat kept,
              const std::stop_token& stop);

  ReadyFrame prepare(int frame);

  /// The frame in the form that is wanted. Throws render::Stopped when it was given up because of a
  /// stop request.
  FramePicture draw(ReadyFrame ready);

  /// How many frames are in flight at once: so many that all threads have something to do while one
  /// is made ready, or its last parts are drawn.
  int in_flight() const;

  /// As render::Tracer::for_frames.
  void for_frames(const render::FrameCallbacks& work) { tracer_.for_frames(work, in_flight()); }

 private:
  FramePicture draw_layers(int frame);
  render::Framebuffer draw_light(ReadyFrame ready);
  template <class Picture>
  Picture draw_picture(ReadyFrame ready);
  render::View view_of(int frame, int eye) const;

  const scenes::Shot& shot_;
  FrameFormat kept_;
  bool layers_;  // frames are drawn in layers
  int eyes_;
  render::Quality quality_;
  render::Tracer tracer_;
};

}  // namespace mien::pipeline
