#include "pipeline/production/film/frame_reuse.h"

#include <string>

#include "pipeline/production/film/film_frames.h"
#include "render/error.h"

namespace mien::pipeline {

std::optional<render::Image8> reusable_frame(FrameStore* store, int frame, const Output& output,
                                             const render::Tone& tone) {
  if (store == nullptr) return std::nullopt;
  const FrameFormat format = output.frames == FrameFormat::none ? FrameFormat::png : output.frames;
  const std::string name = frame_name(format, frame);
  const auto file = store->find(name);
  if (!file) return std::nullopt;
  try {
    return read_frame(*file, format, output.shown_size(), tone);
  } catch (const render::Error&) {
    store->discard(name);
    return std::nullopt;
  }
}

}  // namespace mien::pipeline
