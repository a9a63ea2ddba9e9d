#include "render/tracer/primary_rays.h"

#include "render/math/directions.h"

namespace mien::render {
namespace {

CameraFrame between(const CameraFrame& from, const CameraFrame& to, float time) {
  CameraFrame frame = from;
  frame.position += time * (to.position - from.position);
  frame.forward = (from.forward + time * (to.forward - from.forward)).normalized();
  frame.step_right += time * (to.step_right - from.step_right);
  frame.step_down += time * (to.step_down - from.step_down);
  return frame;
}

}  // namespace

CameraFrame camera_of(const PreparedScene& prepared, const Sample& sample) {
  return prepared.closing_camera ? between(prepared.camera, *prepared.closing_camera, sample.time)
                                 : prepared.camera;
}

void primary_rays(const PreparedScene& prepared, const Samples& samples, LaneVectors& origins,
                  LaneVectors& directions) {
  const LanePoints u = points_for(samples, Dimension::PixelPosition);
  LaneFloats x, y;
  for (int i = 0; i < samples.count; ++i) {
    const Pixel& pixel = *samples[i].pixel;
    x[i] = static_cast<float>(pixel.x) + 0.5f + prepared.filter.offset(u.u[i]);
    y[i] = static_cast<float>(pixel.y) + 0.5f + prepared.filter.offset(u.v[i]);
  }
  if (!prepared.is_per_sample()) return camera_rays(prepared.camera, x, y, origins, directions);
  for (int i = 0; i < samples.count; ++i) {
    const DiscPoint lens =
        disc_point(samples[i].pixel->sampler.point(Dimension::Lens, samples[i].index));
    const CameraRay ray = camera_of(prepared, samples[i]).ray(x[i], y[i], lens.x, lens.y);
    origins.set(i, ray.origin);
    directions.set(i, ray.direction);
  }
}

}  // namespace mien::render
