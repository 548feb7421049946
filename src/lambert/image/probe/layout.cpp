#include "lambert/image/probe/layout.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace lambert::probe {
namespace {

struct Named {
  std::string_view name;
  Layout layout;
};

const std::vector<Named>& table() {
  static const std::vector<Named> layouts{
      {"lat-long", {LatLong{}}},
      {"mirror-ball", {MirrorBall{}}},
      {"angular", {angular_map()}},
      {"fisheye", {Fisheye{}}},
      {"vertical-cross", {Cube{}, Arrangement::vertical_cross}},
      {"horizontal-cross", {Cube{}, Arrangement::horizontal_cross}},
      {"vertical-strip", {Cube{}, Arrangement::vertical_strip}},
      {"horizontal-strip", {Cube{}, Arrangement::horizontal_strip}},
      {"faces", {Cube{}, Arrangement::files}},
      {"opengl-strip", {Cube{.opengl = true}, Arrangement::vertical_strip}},
      {"opengl-faces", {Cube{.opengl = true}, Arrangement::files}},
      {"octahedral", {Octahedral{}}},
      {"equal-area", {EqualArea{}}},
      {"openexr-lat-long", {LatLong{.centre_is_plus_z = true}, Arrangement::single, TexelRule::edge_to_edge}},
      {"openexr-cube", {Cube{}, Arrangement::vertical_strip, TexelRule::edge_to_edge}},
  };
  return layouts;
}

/// In faces: the size of the picture, and where each face lies; the last one may be upside down.
struct Places {
  Vec2i size;
  std::array<Vec2i, 6> at;
  bool last_upside_down = false;
};

std::optional<Places> places(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::vertical_cross: return Places{{3, 4}, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 3}, {1, 1}}}, true};
    case Arrangement::horizontal_cross: return Places{{4, 3}, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}}}};
    case Arrangement::vertical_strip: return Places{{1, 6}, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}};
    case Arrangement::horizontal_strip: return Places{{6, 1}, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}};
    case Arrangement::single:
    case Arrangement::files: break;
  }
  return std::nullopt;
}

constexpr std::size_t behind = 4;  // the index of pz

const Attribute openexr_lat_long{"envmap", "latlong"}, openexr_cube{"envmap", "cube"};

/// Sets OpenEXR's attribute where the picture is what it stands for, and only there.
void set_envmap(Image& picture, const Probe& probe, Arrangement arrangement) {
  picture.attributes.erase("envmap");
  if (probe.texels != TexelRule::edge_to_edge) return;
  if (const auto* map = std::get_if<LatLong>(&probe.projection); map && map->centre_is_plus_z)
    picture.attributes["envmap"] = openexr_lat_long;
  if (const auto* cube = std::get_if<Cube>(&probe.projection);
      cube && !cube->opengl && arrangement == Arrangement::vertical_strip)
    picture.attributes["envmap"] = openexr_cube;
}

std::string size_text(const Image& image) {
  return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

/// The place in the picture of row y of a face, whose last texel comes first when the face is upside down.
struct Row {
  Vec2i first;
  bool reversed;
};
Row row_of(const Places& p, std::size_t face, int n, int y) {
  const bool reversed = face == behind && p.last_upside_down;
  return {p.at[face] * n + Vec2i(0, reversed ? n - 1 - y : y), reversed};
}

const float* texels_from(const Image& image, Vec2i p) {
  return image.row(p.y).data() + static_cast<std::size_t>(p.x) * image.channel_count();
}

/// Copies a row of n texels, or its mirror image.
void copy_row(float* to, const float* from, int n, std::size_t channels, bool reversed) {
  const auto count = static_cast<std::size_t>(n);
  if (!reversed) {
    std::copy_n(from, count * channels, to);
    return;
  }
  for (std::size_t x = 0; x < count; ++x) std::copy_n(from + (count - 1 - x) * channels, channels, to + x * channels);
}

Probe cut_picture(const Layout& layout, const Places& p, const Image& picture) {
  const int n = picture.width() / p.size.x;
  if (n == 0 || picture.width() != n * p.size.x || picture.height() != n * p.size.y)
    throw Error("a picture of " + size_text(picture) + " is no arrangement of square faces " +
                std::to_string(p.size.x) + " across and " + std::to_string(p.size.y) + " down");
  Probe probe{layout.projection, layout.texels, {}};
  for (std::size_t face = 0; face < p.at.size(); ++face) {
    Image& chart = probe.charts.emplace_back(n, n, picture.channels());
    for (int y = 0; y < n; ++y) {
      const auto [first, reversed] = row_of(p, face, n, y);
      copy_row(chart.row(y).data(), texels_from(picture, first), n, picture.channel_count(), reversed);
    }
  }
  probe.charts.front().metadata = picture.metadata;
  probe.charts.front().attributes = picture.attributes;
  return probe;
}

}  // namespace

Layout layout(std::string_view name) {
  for (const Named& n : table())
    if (n.name == name) return n.layout;
  throw Error("unknown layout " + unknown_word(name, layout_names()));
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const Named& n : table()) names.emplace_back(n.name);
  return names;
}

std::optional<std::string> stated_layout(const Image& image) {
  const auto envmap = image.attributes.find("envmap");
  if (envmap == image.attributes.end()) return std::nullopt;
  if (envmap->second == openexr_lat_long) return "openexr-lat-long";
  if (envmap->second == openexr_cube) return "openexr-cube";
  return std::nullopt;
}

Image whole_map(Image picture) { return stated_layout(picture) ? std::move(picture) : displayed(std::move(picture)); }

std::string guess_layout(const Image& image) {
  const auto w = static_cast<std::int64_t>(image.width()), h = static_cast<std::int64_t>(image.height());
  if (auto stated = stated_layout(image)) return *stated;
  if (w == 2 * h) return "lat-long";
  if (4 * w == 3 * h) return "vertical-cross";
  if (3 * w == 4 * h) return "horizontal-cross";
  if (6 * w == h) return "vertical-strip";
  if (w == 6 * h) return "horizontal-strip";
  throw Error(w == h ? "a square picture may be mirror-ball, angular, fisheye, octahedral or equal-area: say which"
                     : "no layout has the shape of a picture of " + size_text(image) + ": say which it is");
}

Probe cut(const Layout& layout, std::vector<Image> pictures) {
  const std::size_t wanted = layout.arrangement == Arrangement::files ? 6 : 1;
  if (pictures.size() != wanted)
    throw Error("expected " + std::to_string(wanted) + (wanted == 1 ? " picture" : " pictures, one of each face") +
                ", got " + std::to_string(pictures.size()));
  if (const auto p = places(layout.arrangement)) return cut_picture(layout, *p, pictures.front());
  const bool square = !std::holds_alternative<LatLong>(layout.projection);
  for (const Image& i : pictures) {
    if (square && i.width() != i.height()) throw Error("expected a square picture, got one of " + size_text(i));
    if (size_text(i) != size_text(pictures.front()) || i.channels() != pictures.front().channels())
      throw Error("the faces differ in size or channels");
  }
  return {layout.projection, layout.texels, std::move(pictures)};
}

std::vector<Image> arranged(Probe probe, Arrangement arrangement) {
  const auto p = places(arrangement);
  if (!p) {
    for (Image& chart : probe.charts) set_envmap(chart, probe, arrangement);
    return std::move(probe.charts);
  }
  const int n = probe.width();
  std::vector<Image> pictures;
  Image& picture = pictures.emplace_back(n * p->size.x, n * p->size.y, probe.charts.front().channels());
  picture.metadata = probe.charts.front().metadata;
  picture.attributes = probe.charts.front().attributes;
  set_envmap(picture, probe, arrangement);
  for (std::size_t face = 0; face < p->at.size(); ++face)
    for (int y = 0; y < n; ++y) {
      const auto [first, reversed] = row_of(*p, face, n, y);
      const Image& chart = probe.charts[face];
      copy_row(&picture.at(first.x, first.y, 0), chart.row(y).data(), n, chart.channel_count(), reversed);
    }
  return pictures;
}

Vec2i chart_size(const AnyProjection& projection, int size) {
  return {std::holds_alternative<LatLong>(projection) ? 2 * size : size, size};
}

float texels_around(const AnyProjection& projection, int width) {
  const auto n = static_cast<float>(width);
  if (std::holds_alternative<LatLong>(projection)) return n;
  if (std::holds_alternative<Cube>(projection)) return 4 * n;
  if (const auto* fisheye = std::get_if<Fisheye>(&projection)) return n * 360 / fisheye->field_of_view.degrees();
  return 2 * n;
}

}  // namespace lambert::probe
