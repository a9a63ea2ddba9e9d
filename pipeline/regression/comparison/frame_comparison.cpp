#include "pipeline/regression/comparison/frame_comparison.h"

#include "render/compare/structural_similarity.h"

namespace mien::pipeline {

FrameComparison compare_pictures(int frame, const render::Image8& before, const render::Image8& now,
                                 int threads) {
  FrameComparison comparison{.frame = frame,
                             .size_before = {before.width, before.height},
                             .size_now = {now.width, now.height}};
  comparison.same_size = before.width == now.width && before.height == now.height;
  comparison.same = comparison.same_size && before.channels == now.channels;
  if (comparison.same || !comparison.same_size) return comparison;
  comparison.difference = render::picture_difference(before, now);
  comparison.openimageio_difference = render::library_difference(before, now);
  comparison.perceived_map = render::perceptual_error(before, now, {}, threads);
  comparison.perceived = render::summary_of(comparison.perceived_map);
  comparison.similarity = render::structural_similarity(before, now).mean;
  return comparison;
}

}  // namespace mien::pipeline
