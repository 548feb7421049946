#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// What stands outside an image (row AA-24): its edge pixel, the image again, the image in a mirror that repeats the
/// edge pixel (… 1 0 | 0 1 2 | 2 1 …), or nothing.
enum class EdgeMode : std::uint8_t { repeat, mirror, clamp, black };
EdgeMode edge_mode(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> edge_mode_names();

/// The index in 0..n-1 that stands for `i`, or -1 for black. `n` is positive and at most 2^30.
inline int edge_index(int i, int n, EdgeMode mode) {
  if (i >= 0 && i < n) return i;
  switch (mode) {
    case EdgeMode::repeat: {
      const int j = i % n;
      return j < 0 ? j + n : j;
    }
    case EdgeMode::mirror: {
      const int period = 2 * n, k = i % period, j = k < 0 ? k + period : k;
      return j < n ? j : period - 1 - j;
    }
    case EdgeMode::clamp: return i < 0 ? 0 : n - 1;
    case EdgeMode::black: return -1;
  }
  return -1;
}

}  // namespace lambert
