#pragma once
/// Unidirectional path tracing with next-event estimation.
///
/// The radiance along a camera ray is the sum over path lengths k of
///   L_k = β_k ( w_bsdf Le(x_k) + w_light f Le(y) |cos| V / p_light ),
/// where β_k = Π f |cos| / p_bsdf is the throughput, y a point sampled on a light, and the weights are those of
/// multiple importance sampling (Veach 1997, ch. 9; the power heuristic). Emission at x_k is thus counted once, however
/// it was found. Russian roulette ends a path with probability 1 - q and divides β of survivors by q (Arvo and Kirk
/// 1990).

#include "lambert/render/method.h"
#include "lambert/render/path/path_settings.h"

#include <cstdint>

namespace lambert {

/// What a path is traced for; `guide` ends where the guide is found.
enum class PathGoal : std::uint8_t { radiance, radiance_and_features, guide };

Method::Estimate trace_path(const Scene& scene, const PathSettings& settings, const CameraRay& camera_ray,
                            Sampler& sampler, PathGoal goal);

}  // namespace lambert
