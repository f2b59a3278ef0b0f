#pragma once

#include "core/formats/scene_loader.h"

namespace etalon::p3f {

using Loader = SceneLoader;

/// Returns the course's material for objects that precede all materials; its programs leave that
/// undefined.
Material default_material();

// One function for each kind of statement that no other format has. It reads the values after the
// keyword and adds them to the scene.
void read_accel(Loader&);
void read_samples(Loader&);
void read_environment(Loader&);
void read_light(Loader&);
void read_point_light(Loader&);
void read_mat(Loader&);
void read_f(Loader&);
void read_box(Loader&);
void read_plane(Loader&);
void read_hessian_plane(Loader&);
void read_mesh(Loader&);

}  // namespace etalon::p3f
