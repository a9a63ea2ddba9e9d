#include "pipeline/production/film/frame_writer.h"

#include <variant>

#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t waiting_frames = 1;

}  // namespace

FrameWriter::FrameWriter(const FilmSettings& settings, const render::Tone& tone,
                         const FrameKeeping& kept, const FrameSink& sink)
    : settings_(settings), tone_(tone), kept_(kept), sink_(sink), queue_(waiting_frames) {
  thread_ = std::thread([this] { write_all(); });
}

FrameWriter::~FrameWriter() {
  queue_.close();
  if (thread_.joinable()) thread_.join();
}

void FrameWriter::finish() {
  queue_.close();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

void FrameWriter::write_all() {
  try {
    PendingFrame frame;
    while (queue_.pop(frame)) {
      const render::Image8 shown = stored_picture(frame);
      sink_(frame.number, shown);
    }
  } catch (...) {
    failure_ = std::current_exception();
    queue_.close();
  }
}

// The picture as its file has it, if it is written to one; moves the frame's own picture.
render::Image8 FrameWriter::stored_picture(PendingFrame& frame) {
  if (frame.is_stored || kept_.store == nullptr || steady_seconds() < kept_.from_seconds)
    return std::move(std::get<render::Image8>(frame.picture));
  const FrameFormat format = settings_.output.frames;
  render::Image8 read_back;
  kept_.store->put(
      frame_name(format, frame.number),
      [&](const std::filesystem::path& file) { write_frame(file, frame.picture); },
      [&](const std::filesystem::path& file) {
        frame.picture = {};  // as large as what is read
        read_back = read_frame(file, format, settings_.output.shown_size(), tone_);
      });
  return read_back;
}

}  // namespace mien::pipeline
