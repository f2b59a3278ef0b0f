// The parts of the catalogue, each about one shape or one kind of scene.
#pragma once

#include "bench/hard_cases/hard_case.h"

namespace etalon::hard {

std::vector<HardCase> sphere_cases();
std::vector<HardCase> shell_cases();
std::vector<HardCase> cylinder_cases();
std::vector<HardCase> cone_cases();
std::vector<HardCase> ellipsoid_cases();
std::vector<HardCase> closed_cylinder_cases();
std::vector<HardCase> plane_cases();
std::vector<HardCase> plane_pair_cases();
std::vector<HardCase> box_cases();
std::vector<HardCase> triangle_cases();
std::vector<HardCase> triangle_group_cases();
std::vector<HardCase> polygon_cases();
std::vector<HardCase> polygon_group_cases();
std::vector<HardCase> ring_cases();
std::vector<HardCase> curve_cases();
std::vector<HardCase> ring_pair_cases();
std::vector<HardCase> quadric_cases();
std::vector<HardCase> quadric_group_cases();
std::vector<HardCase> revolved_cases();
std::vector<HardCase> aimed_cases();
std::vector<HardCase> mesh_cases();
std::vector<HardCase> random_scene_cases();
std::vector<HardCase> tree_cases();
std::vector<HardCase> instance_cases();
std::vector<HardCase> adversarial_cases();
std::vector<HardCase> grid_cases();
std::vector<HardCase> range_cases();

}  // namespace etalon::hard
