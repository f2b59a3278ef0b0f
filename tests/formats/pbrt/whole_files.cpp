#include "tests/formats/pbrt/whole_files.h"

namespace etalon::pbrt {

const std::vector<std::string>& whole_files() {
    static const std::vector<std::string> scenes = {
        R"(LookAt 3 4 1.5  .5 .5 0  0 0 1 # eye
Camera "perspective" "float fov" [ 45 ]
Sampler "stratified" "bool jitter" "false" "integer xsamples" 8
Film "image" "string filename" "a.exr" "float cropwindow" [0 .5 0 .5]
PixelFilter "mitchell" "float B" .3
WorldBegin
LightSource "infinite" "rgb L" [.4 .45 .5]
LightSource "distant" "point from" [ -30 40 100 ] "blackbody L" [3000 1.5]
AttributeBegin
  Texture "checks" "spectrum" "checkerboard" "float uscale" [8] "rgb tex1" [.1 .1 .1]
  Material "matte" "texture Kd" "checks"
  Translate 0 0 -1
  Shape "trianglemesh" "integer indices" [0 1 2 0 3 1]
    "point P" [ -20 -20 0 20 -20 0 20 20 0 -20 20 0 ] "float st" [ 0 0 1 0 5 5 0 1 ]
AttributeEnd
WorldEnd)",
        R"(TransformTimes 0 1 ActiveTransform EndTime Rotate 5 0 0 1 ActiveTransform All
Camera "environment" Accelerator "kdtree" Integrator "volpath" "integer pixelbounds" [0 1 0 1]
MakeNamedMedium "fog" "string type" "heterogeneous" "float density" [1 2] "integer nx" 2
WorldBegin
MakeNamedMaterial "a" "string type" "mix" "string namedmaterial1" "b"
ObjectBegin "o" MediumInterface "fog" "" NamedMaterial "a" Shape "sphere" "rgb Kd" [1 0 0]
TransformBegin ConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 5 1 ] Shape "disk" TransformEnd
ObjectEnd
CoordinateSystem "here" Scale 2 2 2 ObjectInstance "o" CoordSysTransform "here"
ReverseOrientation AreaLightSource "diffuse" "spectrum L" [400 1 700 2] Shape "cylinder"
WorldEnd
WorldBegin Shape "sphere" WorldEnd)"};
    return scenes;
}

}  // namespace etalon::pbrt
