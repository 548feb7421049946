#pragma once
/// Words of pbrt-v2 and v3, which readers of pbrt-v4 text meet: what to tell the user.

#include <string>
#include <string_view>

namespace lambert::pbrt {

/// A sentence about a directive of an older pbrt; empty when it is none.
std::string old_directive_hint(std::string_view directive);
/// The same for the type of a parameter ("color"), of a material ("matte"), and of any other thing; each starts with
/// "; " so that it can follow a message.
std::string old_parameter_type_hint(std::string_view type);
std::string old_material_hint(std::string_view type);
std::string old_type_hint(std::string_view type);

}  // namespace lambert::pbrt
