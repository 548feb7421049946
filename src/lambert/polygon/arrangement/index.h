#pragma once

#include <cstdint>

namespace lambert::polygon::arrangement {

/// The index of nothing.
constexpr std::uint32_t none = 0xffffffff;

}  // namespace lambert::polygon::arrangement
