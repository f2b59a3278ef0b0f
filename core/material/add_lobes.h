// One function for each material, which adds its lobes at a point.
#pragma once

#include "core/material/point_values.h"

namespace etalon {

void add_lobes(const MatteMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const PlasticMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const MirrorMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const MetalMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const SubstrateMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const GlassMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const TranslucentMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const UberMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const DisneyMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const SubsurfaceMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const KdSubsurfaceMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const FourierMaterial& material, const PointValues& values, LobeList& lobes);
void add_lobes(const HairMaterial& material, const PointValues& values, LobeList& lobes);

}  // namespace etalon
