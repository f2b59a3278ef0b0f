// The one file that depends on the version of Embree: 3.12 and 3.13 (Debian 12), or 4 (Debian 13).
//
// In both, the data of a query is attached to its context by inheritance. Embree 4 passes the
// context inside arguments, and its callbacks must say whether they found a hit. It has no ray
// streams, which are not used here. Its geometries have the mask 1 by default, so a ray's mask must
// be all ones (query.h sets it).
#pragma once

#if ETALON_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace etalon {

#if RTC_VERSION_MAJOR >= 4

using EmbreeContext = RTCRayQueryContext;

inline void initialise(EmbreeContext& context) {
    rtcInitRayQueryContext(&context);
}

inline void embree_intersect(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
}

inline void embree_occluded(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    rtcOccluded1(scene, &ray, &arguments);
}

/// Reports the result at the end of a callback for one ray.
template <class CallbackArguments>
void report(const CallbackArguments& arguments, bool hit) {
    arguments.valid[0] = hit ? -1 : 0;
}

#else

using EmbreeContext = RTCIntersectContext;

inline void initialise(EmbreeContext& context) {
    rtcInitIntersectContext(&context);
}

inline void embree_intersect(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
    rtcIntersect1(scene, &context, &ray);
}

inline void embree_occluded(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
    rtcOccluded1(scene, &context, &ray);
}

template <class CallbackArguments>
void report(const CallbackArguments&, bool) {}

#endif

/// Intersects a scene without callbacks.
inline void embree_intersect(RTCScene scene, RTCRayHit& ray) {
    EmbreeContext context;
    initialise(context);
    embree_intersect(scene, context, ray);
}

inline void embree_occluded(RTCScene scene, RTCRay& ray) {
    EmbreeContext context;
    initialise(context);
    embree_occluded(scene, context, ray);
}

}  // namespace etalon
