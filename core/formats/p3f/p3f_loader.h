#pragma once

#include "core/formats/scene_loader.h"

namespace etalon::p3f {

using Loader = SceneLoader;

/// The course's own for objects before any (its programs leave it to chance).
Material default_material();

// One per kind of statement that no other format has: reads what follows the keyword and adds it
// to the scene.
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
