#pragma once
#include "lambert/image/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class GapFilling {
  push_pull,  ///< averages of what is covered, from ever coarser levels: smooth (Gortler et al. 1996)
  nearest,    ///< the nearest covered pixel by Euclidean distance: charts grow
};
GapFilling gap_filling(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> gap_filling_names();

/// Row AA-23: the gaps between an atlas's charts filled from the charts, so that no average of texels takes in
/// background. `coverage` (its first channel, clamped to [0,1], NaN 0; the atlas's own size) says how much of each
/// pixel belongs to a chart. Pixels are premultiplied by it: what was uncovered is added, and A, if there, becomes 1; a
/// pixel covered wholly stays as it is. An atlas of which nothing is covered stays as it is. Throws Error when the
/// sizes differ.
Image gaps_filled(const Image& atlas, const Image& coverage, GapFilling method = GapFilling::push_pull);

/// The alpha channel as a coverage. Throws Error when there is none.
Image coverage_of(const Image& atlas);

}  // namespace lambert
