#include "lambert/image/filter/fill_gaps.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/filter/nearest_covered.h"

#include <algorithm>

namespace lambert {
namespace {

/// Sums of what is covered and, in the last channel, of the coverage; each level a quarter of the pixels before it.
Image gathered(const Image& fine) {
  Image out((fine.width() + 1) / 2, (fine.height() + 1) / 2, fine.channels());
  const std::size_t channels = fine.channel_count();
  parallel_for(static_cast<std::size_t>(out.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < out.width(); ++x) {
      for (int j = 2 * y; j < std::min(2 * y + 2, fine.height()); ++j)
        for (int i = 2 * x; i < std::min(2 * x + 2, fine.width()); ++i)
          for (std::size_t c = 0; c < channels; ++c) out.at(x, y, c) += fine.at(i, j, c);
      // At most a whole pixel: one that is covered enough needs nothing from coarser levels.
      if (const float w = out.at(x, y, channels - 1); w > 1)
        for (std::size_t c = 0; c < channels; ++c) out.at(x, y, c) /= w;
    }
  });
  return out;
}

/// What is missing of `fine` comes from `coarse`, which is covered everywhere, between whose pixels it is interpolated.
void scatter(const Image& coarse, Image& fine) {
  const std::size_t channels = fine.channel_count();
  parallel_for(static_cast<std::size_t>(fine.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    // A pixel's centre lies a quarter from its parent's, towards one neighbour of it.
    const int y0 = y / 2, y1 = std::clamp(y0 + (y % 2 ? 1 : -1), 0, coarse.height() - 1);
    for (int x = 0; x < fine.width(); ++x) {
      const float missing = 1 - fine.at(x, y, channels - 1);
      if (!(missing > 0)) continue;
      const int x0 = x / 2, x1 = std::clamp(x0 + (x % 2 ? 1 : -1), 0, coarse.width() - 1);
      for (std::size_t c = 0; c < channels; ++c)
        fine.at(x, y, c) += missing * (0.5625f * coarse.at(x0, y0, c) + 0.1875f * coarse.at(x1, y0, c) +
                                       0.1875f * coarse.at(x0, y1, c) + 0.0625f * coarse.at(x1, y1, c));
    }
  });
}

/// Covered everywhere, if anything is.
void push_pull(Image& image) {
  if (image.width() == 1 && image.height() == 1) {
    const std::size_t last = image.channel_count() - 1;
    if (const float w = image.at(0, 0, last); w > 0)
      for (std::size_t c = 0; c <= last; ++c) image.at(0, 0, c) /= w;
    return;
  }
  Image coarse = gathered(image);
  push_pull(coarse);
  scatter(coarse, image);
}

void take_nearest(Image& image) {
  const std::size_t last = image.channel_count() - 1;
  const std::vector<Vec2i> nearest = nearest_covered(image, last);
  const Image original = image;
  parallel_for(static_cast<std::size_t>(image.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.width(); ++x) {
      const float missing = 1 - original.at(x, y, last);
      const Vec2i from = nearest[row * static_cast<std::size_t>(image.width()) + static_cast<std::size_t>(x)];
      if (!(missing > 0) || from.x < 0) continue;
      for (std::size_t c = 0; c <= last; ++c)
        image.at(x, y, c) += missing * original.at(from.x, from.y, c) / original.at(from.x, from.y, last);
    }
  });
}

}  // namespace

GapFilling gap_filling(std::string_view name) {
  const std::vector<std::string> names = gap_filling_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw Error("unknown way to fill gaps " + unknown_word(name, names));
  return static_cast<GapFilling>(found - names.begin());
}

std::vector<std::string> gap_filling_names() { return {"push-pull", "nearest"}; }

Image coverage_of(const Image& atlas) {
  const auto alpha = atlas.channel("A");
  if (!alpha) throw Error("the atlas has no channel A that says what is covered");
  Image coverage(atlas.width(), atlas.height(), {"Y"});
  for (int y = 0; y < atlas.height(); ++y)
    for (int x = 0; x < atlas.width(); ++x) coverage.at(x, y, 0) = atlas.at(x, y, *alpha);
  return coverage;
}

Image gaps_filled(const Image& atlas, const Image& coverage, GapFilling method) {
  if (atlas.width() != coverage.width() || atlas.height() != coverage.height())
    throw Error("the coverage is " + std::to_string(coverage.width()) + "x" + std::to_string(coverage.height()) +
                " pixels, the atlas " + std::to_string(atlas.width()) + "x" + std::to_string(atlas.height()));
  const std::size_t channels = atlas.channel_count();
  std::vector<std::string> names = atlas.channels();
  names.emplace_back("coverage");
  Image work(atlas.width(), atlas.height(), names);
  bool any = false;
  for (int y = 0; y < atlas.height(); ++y)
    for (int x = 0; x < atlas.width(); ++x) {
      const float given = coverage.at(x, y, 0), w = given > 0 ? std::min(given, 1.0f) : 0;
      work.at(x, y, channels) = w;
      any = any || w > 0;
      // Uncovered pixels may hold anything; they count for nothing.
      for (std::size_t c = 0; c < channels; ++c) work.at(x, y, c) = w > 0 ? atlas.at(x, y, c) : 0;
    }
  if (!any) return atlas;
  if (method == GapFilling::push_pull)
    push_pull(work);
  else
    take_nearest(work);
  Image out = atlas;
  const auto alpha = atlas.channel("A");
  for (int y = 0; y < atlas.height(); ++y)
    for (int x = 0; x < atlas.width(); ++x)
      for (std::size_t c = 0; c < channels; ++c) out.at(x, y, c) = alpha == c ? 1 : work.at(x, y, c);
  return out;
}

}  // namespace lambert
