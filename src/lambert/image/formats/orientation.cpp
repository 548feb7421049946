#include "lambert/image/formats/orientation.h"

#include <utility>

namespace lambert {
namespace {

/// What tag 274 says about the first row and column: of the picture's sides, the row's and the column's.
struct Turn {
  bool transposed, mirrored, upside_down;  // after the transposition
};
constexpr Turn turns[9] = {{false, false, false}, {false, false, false}, {false, true, false},
                           {false, true, true},   {false, false, true},  {true, false, false},
                           {true, true, false},   {true, true, true},    {true, false, true}};

template <class T>
std::vector<T> turned(const std::vector<T>& stored, std::size_t width, std::size_t height, std::size_t channels,
                      const Turn& turn) {
  const std::size_t seen_width = turn.transposed ? height : width, seen_height = turn.transposed ? width : height;
  std::vector<T> seen;
  seen.reserve(stored.size());
  for (std::size_t y = 0; y < seen_height && !stored.empty(); ++y)
    for (std::size_t x = 0; x < seen_width; ++x) {
      const std::size_t i = turn.mirrored ? seen_width - 1 - x : x, j = turn.upside_down ? seen_height - 1 - y : y;
      const std::size_t at = (turn.transposed ? i * width + j : j * width + i) * channels;
      seen.insert(seen.end(), stored.begin() + static_cast<std::ptrdiff_t>(at),
                  stored.begin() + static_cast<std::ptrdiff_t>(at + channels));
    }
  return seen;
}

}  // namespace

Texels oriented(Texels t, int orientation) {
  if (orientation <= 1 || orientation > 8) return t;
  const Turn& turn = turns[orientation];
  const auto width = static_cast<std::size_t>(t.width), height = static_cast<std::size_t>(t.height);
  const auto channels = static_cast<std::size_t>(t.channels);
  t.bytes = turned(t.bytes, width, height, channels, turn);
  t.floats = turned(t.floats, width, height, channels, turn);
  if (turn.transposed) std::swap(t.width, t.height);
  return t;
}

}  // namespace lambert
