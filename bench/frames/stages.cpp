#include "bench/frames/stages.h"

namespace etalon::frames {
namespace {

template <double FrameFigures::*Seconds>
double of(const FrameFigures& frame) {
    return frame.*Seconds;
}

using F = FrameFigures;

constexpr Stage all[] = {
    {"start", "start", 6, "this program until its main function: loading and linking it",
     of<&F::start>},
    {"load", "load", 7, "reading the scene file, without its images", of<&F::load>},
    {"build", "build", 7, "the backend's structure", of<&F::build>},
    {"images", "images", 7,
     "what the first rendering takes longer than later ones: preparing lights and materials, and "
     "reading the scene's images",
     of<&F::images>},
    {"camera", "camera", 7, "generating the camera rays", of<&F::camera>},
    {"intersection", "inters.", 8, "the frame's rays, traced again by the intersector alone",
     of<&F::intersection>},
    {"shading", "shading", 8,
     "the rest of the rendering: surfaces, lights, and the rays that they send",
     [](const F& f) { return f.shading(); }},
    {"film", "film", 6, "adding the samples up, with the filter if there is one", of<&F::film>},
    {"render", "render", 8, "the whole rendering, from camera rays to film", of<&F::render>},
    {"write", "write", 7, "encoding and writing an EXR, by code that is loaded already",
     of<&F::write>},
};

}  // namespace

std::span<const Stage> stages() {
    return all;
}

}  // namespace etalon::frames
