// Every textbook kernel: for each shape an overload
//
//   std::tuple<Named<...>...> textbook_kernels(scene, shape)
//
// with the plain kernel in float first, which the cost of all others is relative to.
#pragma once

#include "bench/accuracy/textbook/affine.h"
#include "bench/accuracy/textbook/box.h"
#include "bench/accuracy/textbook/cone.h"
#include "bench/accuracy/textbook/curve.h"
#include "bench/accuracy/textbook/plane.h"
#include "bench/accuracy/textbook/polygon.h"
#include "bench/accuracy/textbook/quadric.h"
#include "bench/accuracy/textbook/revolved.h"
#include "bench/accuracy/textbook/ring.h"
#include "bench/accuracy/textbook/sphere.h"
#include "bench/accuracy/textbook/triangle.h"
