#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// The camera of `Camera "type"`, given under the transformation `camera_from_world`. pbrt's cameras look along +z with
/// x to the right and y up (a left-handed space); here the same picture is seen along -z.
Camera make_camera(const Context& context, const ParameterList& list, const std::string& type,
                   const Transform& camera_from_world, Vec2i resolution);
std::vector<std::string> camera_types();

}  // namespace lambert::pbrt
