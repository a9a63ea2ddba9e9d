#pragma once

// Embree 3 and 4 behind one set of calls. In this module, only embree_scene.cpp includes this.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace mien::render::embree {

#if RTC_VERSION_MAJOR >= 4

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8* rays, bool coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect8(valid, scene, rays, &arguments);
}

inline void occluded8(const int* valid, RTCScene scene, RTCRay8* rays, bool coherent) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcOccluded8(valid, scene, rays, &arguments);
}

inline void occluded1(RTCScene scene, RTCRay* ray) { rtcOccluded1(scene, ray); }

#else

inline RTCIntersectContext context_for(bool coherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8* rays, bool coherent) {
  RTCIntersectContext context = context_for(coherent);
  rtcIntersect8(valid, scene, &context, rays);
}

inline void occluded8(const int* valid, RTCScene scene, RTCRay8* rays, bool coherent) {
  RTCIntersectContext context = context_for(coherent);
  rtcOccluded8(valid, scene, &context, rays);
}

inline void occluded1(RTCScene scene, RTCRay* ray) {
  RTCIntersectContext context = context_for(false);
  rtcOccluded1(scene, &context, ray);
}

#endif

}  // namespace mien::render::embree
