#pragma once
/// Scenes whose radiance is known in closed form.

#include "lambert/scene/scene.h"

#include <string>
#include <vector>

namespace lambert {

/// The inside of a unit sphere that reflects `albedo` and emits `emission`: radiance is emission / (1 - albedo)
/// everywhere.
SceneGraph furnace(float albedo, float emission);

/// The inside of a sphere of `radius` around a point light of `intensity`: every wall point sees intensity / radius²,
/// and radiance is (albedo / π) intensity / radius² / (1 - albedo).
SceneGraph point_light_in_sphere(float albedo, float intensity, float radius);

/// A diffuse floor in y = 0 under a unit square lamp of `radiance` at height 1 that faces down; the camera looks at the
/// point below the lamp's centre.
SceneGraph lamp_over_floor(float albedo, float radiance);

/// The same floor under any lamp of `radiance`, which emits on both sides.
SceneGraph floor_under(float albedo, Geometry lamp, const Transform& place, float radiance);

/// The same floor under an environment of `radiance` from everywhere: half of it is seen, and radiance is that times
/// the albedo.
SceneGraph floor_under_sky(float albedo, float radiance);

/// A camera of each kind at the origin, 8x8 pixels. The perspective one is narrow.
std::vector<Camera> cameras_at(Vec3 position, Vec3 target);

}  // namespace lambert
