#pragma once
#include "lambert/formats/gltf/json.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::gltf {

bool is_data_uri(std::string_view uri);
/// The content of "data:[type][;base64],…". Throws Error at `place`, with the offset in the URI, when it is malformed.
std::vector<std::byte> decode_data_uri(std::string_view uri, const JsonView& place);

/// The file that a relative URI means. An empty `folder` means that there are no files. Throws Error at `place` when
/// the URI has a scheme, or names no regular file.
std::filesystem::path resolve_uri(const std::string& uri, const std::filesystem::path& folder, const JsonView& place);

}  // namespace lambert::gltf
