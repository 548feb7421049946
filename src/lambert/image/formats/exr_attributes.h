#pragma once
#include "lambert/image/image.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// True for what describes an OpenEXR file and not its picture: channels, windows, compression, tiles, kind of part;
/// and for the preview.
bool is_exr_layout(std::string_view name, std::string_view type);

/// True for what every header has, and has this value when nothing is meant by it.
bool is_exr_default(std::string_view name, std::string_view value);

/// The value of an attribute, which a file stores as `bytes`, as text (Attribute::value): numbers, the name of an
/// environment map, words; hexadecimal digits for unknown types.
std::string exr_text(const std::string& type, std::span<const std::byte> bytes);

/// The other way. Throws Error naming the attribute when its value is none of its type.
std::vector<std::byte> exr_bytes(const std::string& name, const Attribute& a);

}  // namespace lambert
