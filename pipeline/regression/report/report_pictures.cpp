#include "pipeline/regression/report/report_pictures.h"

#include <algorithm>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/production/archive/scratch_folder.h"
#include "render/image/image_io.h"
#include "render/image/resize.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// The bytes of all pictures, and the width of the widest.
struct PictureSizes {
  std::uintmax_t bytes = 0;
  int widest = 0;
};

PictureSizes sizes_of(const Regression& regression, const ComparedPictures& pictures,
                      bool every_frame) {
  PictureSizes sizes;
  for (const StimulusComparison& one : regression.stimuli) {
    for (const FrameComparison* frame : shown_frames(one, every_frame)) {
      for (const fs::path& file :
           {pictures.before(one.id, frame->frame), pictures.now(one.id, frame->frame),
            pictures.flip(one.id, frame->frame)})
        sizes.bytes += fs::file_size(file);
      if (sizes.widest == 0)  // films of one study are mostly of one size
        sizes.widest = render::check_image(pictures.now(one.id, frame->frame)).width;
    }
  }
  return sizes;
}

}  // namespace

std::vector<const FrameComparison*> shown_frames(const StimulusComparison& one, bool every_frame) {
  std::vector<const FrameComparison*> frames;
  for (const FrameComparison& frame : one.frames)
    if (!frame.same && frame.same_size) frames.push_back(&frame);
  if (every_frame || frames.empty()) return frames;
  return {*std::ranges::max_element(
      frames, {}, [](const FrameComparison* frame) { return frame->perceived.mean; })};
}

ReportPictures fitting_pictures(const Regression& regression, const ComparedPictures& pictures) {
  const auto shown = std::ranges::count_if(regression.stimuli, [](const StimulusComparison& one) {
    return !shown_frames(one, false).empty();
  });
  if (static_cast<std::size_t>(shown) <= most_with_every_frame &&
      sizes_of(regression, pictures, true).bytes <= most_picture_bytes)
    return {};
  const PictureSizes sizes = sizes_of(regression, pictures, false);
  if (sizes.bytes <= most_picture_bytes) return {.every_frame = false};
  for (const int width : {960, 640, 480}) {
    const double scale = std::min(1.0, static_cast<double>(width) / sizes.widest);
    if (scale * scale * static_cast<double>(sizes.bytes) <= most_picture_bytes)
      return {.every_frame = false, .most_width = width};
  }
  return {.every_frame = false, .most_width = 320};
}

std::string picture_uri(const fs::path& file, int most_width) {
  if (most_width > 0) {
    const render::Image8 picture = render::read_png8(file);
    if (picture.width > most_width) {
      const int height = std::max(1, picture.height * most_width / picture.width);
      const ScratchFolder scratch;
      const fs::path small = scratch.path() / "small.png";
      render::write_png(small, render::resized(picture, most_width, height));
      return data_uri("image/png", read_file(small));
    }
  }
  return data_uri("image/png", read_file(file));
}

}  // namespace mien::pipeline
