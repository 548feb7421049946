#include "lambert/image/tonemap/durand.h"

#include "lambert/image/tonemap/bilateral.h"
#include "lambert/image/tonemap/fast_math.h"

#include <algorithm>
#include <cmath>

namespace lambert::tone {
namespace {

/// The values that `percent` of the plane do not exceed, and 100 - `percent`; of a grid of at most 2^18 samples.
std::pair<float, float> inner_range(const Plane& plane, float percent) {
  const std::size_t step = std::max<std::size_t>(1, plane.values.size() >> 18);
  std::vector<float> samples;
  for (std::size_t i = 0; i < plane.values.size(); i += step) samples.push_back(plane.values[i]);
  const auto nth =
      static_cast<std::ptrdiff_t>(static_cast<double>(percent) / 100 * static_cast<double>(samples.size()));
  std::nth_element(samples.begin(), samples.begin() + nth, samples.end());
  const float low = samples[static_cast<std::size_t>(nth)];
  std::nth_element(samples.begin(), samples.end() - 1 - nth, samples.end());
  return {low, *(samples.end() - 1 - nth)};
}

/// The base goes over into the picture itself around steep edges: where values within `reach` pixels range over more
/// than 2.5 deviations, wholly where over 5.
void follow_edges(Plane& base, const Plane& picture, int reach, float deviation) {
  Plane share = range_around(picture, reach);
  for_rows(share.height, [&](int y) {
    for (float& v : share.row(y)) v = at_most(at_least(v / (2.5f * deviation) - 1, 0.0f), 1.0f);
  });
  share = gaussian_blurred(share, 0.5f * static_cast<float>(reach));
  for_rows(base.height, [&](int y) {
    float* const to = base.row(y).data();
    const float* const own = picture.row(y).data();
    const float* const weight = share.row(y).data();
    for (std::size_t x = 0; x < static_cast<std::size_t>(base.width); ++x) to[x] += weight[x] * (own[x] - to[x]);
  });
}

}  // namespace

Plane Durand::map(const LuminanceMap& map) const {
  const float floor = map.percentile(0.1f);
  Plane decades = map.luminance;
  for_rows(decades.height, [&](int y) {
    for (float& v : decades.row(y)) v = fast_log10(v > floor ? v : floor);
  });
  const float larger = static_cast<float>(std::max(decades.width, decades.height));
  const float deviation = spatial * 0.01f * larger;
  Plane base = bilateral_filter(decades, deviation, range);
  const auto [low, high] = inner_range(base, clip);
  follow_edges(base, decades, static_cast<int>(std::ceil(0.4f * deviation)), range);
  const float wanted = std::log10(contrast);
  // A base that is flatter already is left so.
  const float factor = high - low > wanted ? wanted / (high - low) : 1;
  Plane out(decades.width, decades.height);
  for_rows(out.height, [&, top = high](int y) {
    const float* const l = map.luminance.row(y).data();
    const float* const all = decades.row(y).data();
    const float* const b = base.row(y).data();
    const auto to = out.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) {
      const float shown = fast_exp10((b[x] - top) * factor + (all[x] - b[x]));
      // Below the floor in proportion, so that black is black.
      to[x] = l[x] < floor ? shown * (l[x] / floor) : shown;
    }
  });
  return out;
}

}  // namespace lambert::tone
