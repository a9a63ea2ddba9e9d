#pragma once

#include <exception>
#include <thread>
#include <utility>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_frames.h"
#include "pipeline/tasks/bounded_queue.h"

namespace mien::pipeline {

/// A frame to be written, in its stored form, or a frame that was read from the store.
struct PendingFrame {
  int number = 0;
  FramePicture picture;
  bool is_stored = false;
};

/// Where a writer stores frames, and from when on.
struct FrameKeeping {
  FrameStore* store = nullptr;  ///< null: frames are not stored
  double from_seconds = 0.0;    ///< nor before this time of the monotonic clock (steady_seconds)
};

/// Writes frames to the store, if any, reads them back and passes them to a sink, in a separate
/// thread. All arguments must outlive the object.
class FrameWriter {
 public:
  FrameWriter(const FilmSettings& settings, const render::Tone& tone, const FrameKeeping& kept,
              const FrameSink& sink);
  ~FrameWriter();

  /// Adds the next frame, waiting until the queue has room. Returns false, and discards the frame,
  /// once the writer has failed.
  bool push(PendingFrame frame) { return queue_.push(std::move(frame)); }

  /// Waits for the last frame and rethrows any error of the writing thread.
  void finish();

 private:
  void write_all();
  render::Image8 stored_picture(PendingFrame& frame);

  const FilmSettings& settings_;
  const render::Tone& tone_;
  const FrameKeeping kept_;
  const FrameSink& sink_;
  BoundedQueue<PendingFrame> queue_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace mien::pipeline
