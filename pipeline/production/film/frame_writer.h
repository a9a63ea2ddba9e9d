#pragma once

#include <exception>
#include <thread>
#include <utility>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_frames.h"
#include "pipeline/tasks/bounded_queue.h"

namespace mien::pipeline {

/// A frame to be written, in its stored form; or one that was read from the store.
struct PendingFrame {
  int number = 0;
  FramePicture picture;
  bool is_stored = false;
};

/// Writes frames to the store, if any, and hands them to a sink as they are read back: the second
/// half of the work on a film, in a thread of its own. What it is given outlives it.
class FrameWriter {
 public:
  FrameWriter(const FilmSettings& settings, const render::Tone& tone, FrameStore* store,
              const FrameSink& sink);
  ~FrameWriter();

  /// The next frame; waits for room. False, and the frame is lost, once the writer has failed.
  bool push(PendingFrame frame) { return queue_.push(std::move(frame)); }

  /// Waits for the last frame and throws what went wrong.
  void finish();

 private:
  void write_all();
  render::Image8 stored_picture(PendingFrame& frame);

  const FilmSettings& settings_;
  const render::Tone& tone_;
  FrameStore* store_;
  const FrameSink& sink_;
  BoundedQueue<PendingFrame> queue_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace mien::pipeline
