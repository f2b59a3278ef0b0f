// The one file that knows which Embree this is: 3.12 and 3.13 (Debian 12), or 4 (Debian 13).
//
// What a query carries hangs off its context in both, by inheritance. Embree 4 passes the context
// inside arguments, and its callbacks must say whether they found a hit. Ray streams are gone from
// it and not used here; its geometries have the mask 1 by default, so a ray's mask must be all ones
// (query.h sees to that).
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

/// The last thing a callback for one ray does.
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
