#include "lambert/light/light_split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lambert {
namespace {

constexpr int bucket_count = 12;

struct Bucket {
  LightBounds bounds;
  bool used = false;
  void add(const LightBounds& b) {
    bounds = used ? merge(bounds, b) : b;
    used = true;
  }
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = 0, bucket = 0;  // the first part ends with this bucket
};

Bounds3 centre_bounds(std::span<const LightBounds> bounds, std::span<const std::uint32_t> lights) {
  Bounds3 box;
  for (const std::uint32_t l : lights) box.add(bounds[l].box.centre());
  return box;
}

int longest_axis(Vec3 d) { return d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2; }

int bucket_of(const LightBounds& b, const Bounds3& centres, int axis) {
  const float t = (b.box.centre()[axis] - centres.min[axis]) / (centres.max[axis] - centres.min[axis]);
  return std::clamp(static_cast<int>(t * bucket_count), 0, bucket_count - 1);
}

float surface_area(const Bounds3& b) {
  const Vec3 d = b.diagonal();
  return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
}

float cost(const Bucket& b) { return b.bounds.intensity * orientation_measure(b.bounds) * surface_area(b.bounds.box); }

/// The cheapest split along `axis`. `regularisation` favours cutting the box across its longest axis.
Split best_split(const std::array<Bucket, bucket_count>& buckets, int axis, float regularisation) {
  std::array<Bucket, bucket_count> above;  // above[i]: buckets i and up
  above[bucket_count - 1] = buckets[bucket_count - 1];
  for (int i = bucket_count - 2; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    above[k] = above[k + 1];
    if (buckets[k].used) above[k].add(buckets[k].bounds);
  }
  Split best;
  Bucket below;
  for (int i = 0; i + 1 < bucket_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (buckets[k].used) below.add(buckets[k].bounds);
    if (!below.used || !above[k + 1].used) continue;
    const float c = regularisation * (cost(below) + cost(above[k + 1]));
    if (c < best.cost) best = {c, axis, i};
  }
  return best;
}

}  // namespace

std::size_t split_in_halves(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights) {
  const int axis = longest_axis(centre_bounds(bounds, lights).diagonal());
  const auto middle = lights.begin() + static_cast<std::ptrdiff_t>(lights.size() / 2);
  std::nth_element(lights.begin(), middle, lights.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float x = bounds[a].box.centre()[axis], y = bounds[b].box.centre()[axis];
    return x < y || (x == y && a < b);
  });
  return lights.size() / 2;
}

std::size_t split_by_orientation(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights) {
  const Bounds3 centres = centre_bounds(bounds, lights);
  Bounds3 box;
  for (const std::uint32_t l : lights) box.add(bounds[l].box);
  const Vec3 extent = box.diagonal();

  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(centres.max[axis] > centres.min[axis])) continue;
    std::array<Bucket, bucket_count> buckets;
    for (const std::uint32_t l : lights) {
      buckets[static_cast<std::size_t>(bucket_of(bounds[l], centres, axis))].add(bounds[l]);
    }
    const Split split = best_split(buckets, axis, extent[longest_axis(extent)] / extent[axis]);
    if (split.cost < best.cost) best = split;
  }
  // Lights all in one place, or points and flat boxes whose cost does not tell them apart.
  if (!(best.cost > 0) || best.cost == std::numeric_limits<float>::infinity()) return split_in_halves(bounds, lights);
  const auto second = std::partition(lights.begin(), lights.end(), [&](std::uint32_t l) {
    return bucket_of(bounds[l], centres, best.axis) <= best.bucket;
  });
  return static_cast<std::size_t>(second - lights.begin());
}

}  // namespace lambert
