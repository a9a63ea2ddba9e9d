#pragma once

#include <stop_token>
#include <vector>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_frames.h"
#include "render/tracer/tracer.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A frame that is prepared for rendering: one view per eye; none if frames are rendered in layers.
struct ReadyFrame {
  int frame = 0;
  std::vector<render::PreparedView> prepared_views;
};

/// Renders frames of a shot, several at a time, while the next one is prepared. Each tile of a
/// picture is tone-mapped by the thread that rendered it. The shot and the settings must outlive
/// the object.
class FrameDrawer {
 public:
  /// `kept` is the format in which frames are stored. Throws as the tracer does.
  FrameDrawer(const scenes::Shot& shot, const FilmSettings& settings, FrameFormat kept,
              const std::stop_token& stop);

  ReadyFrame prepare(int frame);

  /// Renders the frame in the form for storage. Throws render::Stopped if it was abandoned because
  /// of a stop request.
  FramePicture draw(ReadyFrame ready);

  /// Returns the number of frames in flight at once, chosen so that no thread is idle while a frame
  /// is prepared or its last tiles are rendered; 1 with a single thread, or if frames are rendered
  /// in layers.
  int in_flight() const;

  /// Works as render::Tracer::for_frames does.
  void for_frames(const render::FrameCallbacks& work) { tracer_.for_frames(work, in_flight()); }

 private:
  FramePicture draw_layers(int frame);
  render::Framebuffer draw_light(ReadyFrame ready);
  template <class Picture>
  Picture draw_picture(ReadyFrame ready);
  render::View view_of(int frame, int eye) const;

  const scenes::Shot& shot_;
  FrameFormat kept_;
  bool layers_;  // frames are rendered in layers
  int eyes_;
  render::Quality quality_;
  render::Tracer tracer_;
};

}  // namespace mien::pipeline
