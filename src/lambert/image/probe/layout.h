#pragma once
/// How a map is stored: its projection, where the faces of a cube lie in the picture, and what a texel stands for.

#include "lambert/image/image.h"
#include "lambert/image/probe/projection.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::probe {

/// Where the charts lie in the picture. Crosses have the face ahead (nz) in the middle, px to its right, py above it,
/// ny below it, and pz right of px, or upside down below ny. Strips have the faces in their order, px first.
enum class Arrangement : std::uint8_t {
  single,
  vertical_cross,
  horizontal_cross,
  vertical_strip,
  horizontal_strip,
  files
};

/// What of the chart texel i of n stands for: i/n to (i+1)/n, or, as OpenEXR has it, all that is nearest to i/(n-1), so
/// that the outermost texels lie on the chart's edges.
enum class TexelRule : std::uint8_t { cells, edge_to_edge };

struct Layout {
  AnyProjection projection = LatLong{};
  Arrangement arrangement = Arrangement::single;
  TexelRule texels = TexelRule::cells;
};

/// lat-long, mirror-ball, angular, fisheye, vertical-cross, horizontal-cross, vertical-strip, horizontal-strip, faces,
/// opengl-strip, opengl-faces, octahedral, equal-area, openexr-lat-long, openexr-cube. Throws Error for other names.
Layout layout(std::string_view name);
std::vector<std::string> layout_names();
/// What OpenEXR's attribute `envmap` says a picture is, openexr-lat-long or openexr-cube, if it has it.
std::optional<std::string> stated_layout(const Image& image);
/// What of a picture is the map: all data where `envmap` is set, as OpenEXR has it, else what is shown.
Image whole_map(Image picture);
/// What a picture of this shape is most likely, as a name; throws Error for a shape of no or of several layouts (1:1)
/// that says so. The stated layout goes before the shape.
std::string guess_layout(const Image& image);

/// A map of directions, its charts all of one size and with the same channels.
struct Probe {
  AnyProjection projection = LatLong{};
  TexelRule texels = TexelRule::cells;
  std::vector<Image> charts;

  int width() const { return charts.front().width(); }
  int height() const { return charts.front().height(); }
};

/// Cuts a picture into charts. Throws Error when its shape is not the layout's; `files` takes six pictures, all others
/// one. A lat-long map may have any shape.
Probe cut(const Layout& layout, std::vector<Image> pictures);
/// The picture, or the six, of a map; what of a cross shows nothing is 0. Metadata and attributes go along, but
/// `envmap` is set for openexr-lat-long and openexr-cube alone: OpenEXR's functions would turn any other picture half
/// around.
std::vector<Image> arranged(Probe probe, Arrangement arrangement);

/// Columns and rows of a chart of `size`: a lat-long map is `size` high and twice as wide, all others are square.
Vec2i chart_size(const AnyProjection& projection, int size);
/// Texels around a great circle that a chart of this width stands for; for choosing sizes.
float texels_around(const AnyProjection& projection, int width);

}  // namespace lambert::probe
