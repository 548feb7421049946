#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// A channel of an OpenEXR file and what it is called in the image.
struct ExrChannel {
  std::string stored, name;
  std::size_t part = 0;
};

/// The part of a file whose channels keep plain names: the one named "rgba", "rgb", "beauty" or "color" (in any case,
/// the first of several), else the first.
std::size_t main_part(const std::vector<std::string>& part_names);

/// Gives all channels different names. Those of the main part keep theirs; "R" of part "diffuse" becomes "diffuse.R",
/// but "diffuse.R" of that part stays. A name that is taken gets the part's number before it. Given, per part, the
/// part's name and its channels; the result is in the same order.
std::vector<ExrChannel> named_channels(const std::vector<std::string>& part_names,
                                       const std::vector<std::vector<std::string>>& channels);

/// Indices of `names` so that R, G, B, Y, A come first and the others follow as they are.
std::vector<std::size_t> colour_first(const std::vector<std::string>& names);

}  // namespace lambert
