#pragma once
/// Channels by name: "R", "diffuse.R". What stands before the last point is the layer.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// Three channels of colour by their places in a list of names: "R", "G", "B" and "diffuse.R", "diffuse.G",
/// "diffuse.B". Layers of directions, positions and ids are no colours, whatever their channels are called.
struct ColourTriple {
  std::size_t r = 0, g = 0, b = 0;
};
std::vector<ColourTriple> colour_triples(const std::vector<std::string>& names);

/// Which channels are amounts of light, that exposure multiplies: colour_triples() and luminance ("Y").
std::vector<bool> light_channels(const std::vector<std::string>& names);

/// With ASCII letters in lower case: how names are compared where programs spell them differently.
std::string lower(std::string_view name);

/// Positions, depths, ids, counts and variances, which need all digits of a float.
bool needs_full_floats(std::string_view channel);

/// A channel of an image under a name that may be new.
struct ChannelChoice {
  std::size_t stored = 0;
  std::string name;
};
/// Those of `names` in `layer` (all when it is empty), called without it; of these the `wanted` ones in this order (all
/// when there are none), each "name" or "new=old". Throws Error "file: ..." with the known layers or channels.
std::vector<ChannelChoice> chosen_channels(const std::vector<std::string>& names, const std::string& layer,
                                           const std::vector<std::string>& wanted, const std::string& file);

}  // namespace lambert
