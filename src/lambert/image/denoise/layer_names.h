#pragma once
#include "lambert/image/image.h"

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace lambert::denoise {

/// The channels "layer.R", "layer.G", "layer.B" (or .X .Y .Z, or .r .g .b), three in order, of the first of `layers`
/// that the image has, also below the name of a view layer ("ViewLayer.layer.R"); the bare "R", "G", "B" for the empty
/// name. Nothing when there is none.
std::vector<std::size_t> find_triple(const Image& image, std::initializer_list<std::string_view> layers);

/// One channel of the first of `names` that the image has, also below the name of a view layer if it is longer than a
/// letter.
std::vector<std::size_t> find_single(const Image& image, std::initializer_list<std::string_view> names);

}  // namespace lambert::denoise
