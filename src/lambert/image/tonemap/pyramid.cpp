#include "lambert/image/tonemap/pyramid.h"

namespace lambert::tone {
namespace {

constexpr float kernel[] = {1 / 16.0f, 4 / 16.0f, 6 / 16.0f, 4 / 16.0f, 1 / 16.0f};

}  // namespace

Plane halved(const Plane& plane) {
  const int width = (plane.width + 1) / 2, height = (plane.height + 1) / 2;
  Plane out(width, height);
  for_rows(height, [&](int y) {
    std::vector<float> line(static_cast<std::size_t>(plane.width) + 4, 0.0f);
    for (int i = -2; i <= 2; ++i) {
      const auto from = plane.row(std::clamp(2 * y + i, 0, plane.height - 1));
      const float weight = kernel[i + 2];
      for (std::size_t x = 0; x < from.size(); ++x) line[x + 2] += weight * from[x];
    }
    line[0] = line[1] = line[2];
    const std::size_t end = line.size();
    line[end - 1] = line[end - 2] = line[end - 3];
    const auto to = out.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) {
      const float* const at = line.data() + 2 * x;
      to[x] = kernel[0] * (at[0] + at[4]) + kernel[1] * (at[1] + at[3]) + kernel[2] * at[2];
    }
  });
  return out;
}

Plane doubled(const Plane& plane, int width, int height) {
  Plane out(width, height);
  for_rows(height, [&](int y) {
    const auto coarse_row = [&](int i) { return plane.row(std::clamp(i, 0, plane.height - 1)); };
    const int own = y / 2;
    const auto before = coarse_row(own - 1), at = coarse_row(own), after = coarse_row(own + 1);
    std::vector<float> line(at.size());
    for (std::size_t x = 0; x < line.size(); ++x)
      line[x] = y % 2 ? 0.5f * (at[x] + after[x]) : 0.125f * (before[x] + after[x]) + 0.75f * at[x];
    const auto to = out.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) {
      const std::size_t i = x / 2, next = std::min(i + 1, line.size() - 1), last = i > 0 ? i - 1 : 0;
      to[x] = x % 2 ? 0.5f * (line[i] + line[next]) : 0.125f * (line[last] + line[next]) + 0.75f * line[i];
    }
  });
  return out;
}

}  // namespace lambert::tone
