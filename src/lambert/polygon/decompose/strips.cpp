#include "lambert/polygon/decompose/strips.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

template <std::size_t n>
std::vector<std::array<std::uint32_t, n>> pieces_of_list(std::span<const std::uint32_t> list) {
  std::vector<std::array<std::uint32_t, n>> pieces(list.size() / n);
  for (std::size_t i = 0; i < n * pieces.size(); ++i) pieces[i / n][i % n] = list[i];
  return pieces;
}

template <class Piece>
Indices all_corners(std::span<const Piece> pieces) {
  Indices list;
  for (const Piece& piece : pieces) list.insert(list.end(), piece.begin(), piece.end());
  return list;
}

template <class Piece>
bool same_but_for_first(const Piece& a, Piece b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

template <class Piece>
bool same_pieces(std::span<const Piece> a, const std::vector<Piece>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_but_for_first<Piece>);
}

/// The first of these encodings that decodes to the pieces.
template <class Piece, class Encode, class Decode>
std::optional<Indices> encoded(std::span<const Piece> pieces, const Encode& encode, const Decode& decode) {
  if (pieces.empty()) return Indices{};
  for (std::size_t turn = 0; turn < std::tuple_size_v<Piece>; ++turn) {
    Piece first = pieces[0];
    std::rotate(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(turn), first.end());
    Indices code = encode(first);
    if (same_pieces(pieces, decode(code))) return code;
  }
  return std::nullopt;
}

/// The corner of `t` that is neither a nor b, or a where there is none.
std::uint32_t third_corner(const Triangle& t, std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t v : t)
    if (v != a && v != b) return v;
  return a;
}

}  // namespace

std::vector<Triangle> triangles_of_list(std::span<const std::uint32_t> list) { return pieces_of_list<3>(list); }
std::vector<Quad> quads_of_list(std::span<const std::uint32_t> list) { return pieces_of_list<4>(list); }

std::vector<Triangle> triangles_of_strip(std::span<const std::uint32_t> strip) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const bool reversed = i % 2 == 1;
    triangles.push_back({strip[reversed ? i - 1 : i - 2], strip[reversed ? i - 2 : i - 1], strip[i]});
  }
  return triangles;
}

std::vector<Triangle> triangles_of_fan(std::span<const std::uint32_t> fan) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 2; i < fan.size(); ++i) triangles.push_back({fan[0], fan[i - 1], fan[i]});
  return triangles;
}

std::vector<Quad> quads_of_strip(std::span<const std::uint32_t> strip) {
  std::vector<Quad> quads;
  for (std::size_t i = 3; i < strip.size(); i += 2)
    quads.push_back({strip[i - 3], strip[i - 2], strip[i], strip[i - 1]});
  return quads;
}

Indices list_of(std::span<const Triangle> triangles) { return all_corners(triangles); }
Indices list_of(std::span<const Quad> quads) { return all_corners(quads); }

std::optional<Indices> strip_of(std::span<const Triangle> triangles) {
  const auto encode = [&](const Triangle& first) {
    Indices strip(first.begin(), first.end());
    for (const Triangle& t : triangles.subspan(1))
      strip.push_back(third_corner(t, strip[strip.size() - 2], strip.back()));
    return strip;
  };
  return encoded(triangles, encode, [](const Indices& code) { return triangles_of_strip(code); });
}

std::optional<Indices> fan_of(std::span<const Triangle> triangles) {
  const auto encode = [&](const Triangle& first) {
    Indices fan(first.begin(), first.end());
    for (const Triangle& t : triangles.subspan(1)) fan.push_back(third_corner(t, fan[0], fan.back()));
    return fan;
  };
  return encoded(triangles, encode, [](const Indices& code) { return triangles_of_fan(code); });
}

std::optional<Indices> strip_of(std::span<const Quad> quads) {
  const auto encode = [&](const Quad& first) {
    Indices strip = {first[0], first[1], first[3], first[2]};
    for (const Quad& q : quads.subspan(1)) {
      const auto at = std::find(q.begin(), q.end(), strip[strip.size() - 2]);
      const auto k = at == q.end() ? 0 : static_cast<std::size_t>(at - q.begin());
      const std::uint32_t far_end = q[(k + 3) % 4], near_end = q[(k + 2) % 4];
      strip.push_back(far_end);
      strip.push_back(near_end);
    }
    return strip;
  };
  return encoded(quads, encode, [](const Indices& code) { return quads_of_strip(code); });
}

std::size_t Strips::vertex_count() const {
  std::size_t count = 0;
  for (const Indices& strip : strips) count += strip.size();
  return count;
}

}  // namespace lambert::polygon
