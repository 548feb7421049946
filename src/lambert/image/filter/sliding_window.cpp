#include "lambert/image/filter/sliding_window.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/filter/lanes.h"

#include <algorithm>
#include <vector>

namespace lambert {
namespace {

struct Sum {
  Lanes operator()(const Lanes& a, const Lanes& b) const { return a + b; }
};
/// x ? y : z takes z where a comparison with NaN fails.
struct Least {
  Lanes operator()(const Lanes& a, const Lanes& b) const {
    const Lanes smaller = a < b ? a : b;
    return smaller == smaller ? smaller : a;
  }
};
struct Greatest {
  Lanes operator()(const Lanes& a, const Lanes& b) const {
    const Lanes greater = a > b ? a : b;
    return greater == greater ? greater : a;
  }
};

/// Along a line of `n`, eight lines at once: in[i · stride], for i in [0, n). Every block of 2 radius + 1 windows is
/// joined from what ends one block of the input and begins the next one.
template <class Operation>
void slide(const float* in, std::size_t stride, int n, int radius, EdgeMode edge, std::vector<Lanes>& tails,
           float* out) {
  const Operation join;
  const int window = 2 * radius + 1;
  const auto get = [&](int i) {
    const int at = edge_index(i, n, edge);
    return at < 0 ? Lanes{} : load_lanes(in + static_cast<std::size_t>(at) * stride);
  };
  const auto tail = [&](int j) -> Lanes& { return tails[static_cast<std::size_t>(j)]; };
  for (int begin = 0; begin < n; begin += window) {
    tail(window - 1) = get(begin + radius);
    for (int j = window - 2; j >= 0; --j) tail(j) = join(get(begin - radius + j), tail(j + 1));
    const int count = std::min(window, n - begin);
    float* to = out + static_cast<std::size_t>(begin) * stride;
    store_lanes(to, tail(0));
    Lanes head = get(begin + radius + 1);
    for (int j = 1; j < count; ++j) {
      store_lanes(to + static_cast<std::size_t>(j) * stride, join(tail(j), head));
      head = join(head, get(begin + radius + 1 + j));
    }
  }
}

template <class Operation>
Image slid_by(const Image& image, Vec2i radius, EdgeMode edge) {
  const auto floats = static_cast<std::size_t>(image.width()) * image.channel_count();
  const auto height = static_cast<std::size_t>(image.height());
  const auto tails = [](int r) { return std::vector<Lanes>(static_cast<std::size_t>(2 * r + 1)); };

  Image down = image;
  if (radius.y > 0)
    parallel_for((floats + lane_count - 1) / lane_count, [&](std::size_t strip) {
      std::vector<Lanes> buffer = tails(radius.y);
      const std::size_t x = strip * lane_count;
      if (x + lane_count <= floats) {
        slide<Operation>(image.pixels().data() + x, floats, image.height(), radius.y, edge, buffer,
                         down.pixels().data() + x);
        return;
      }
      std::vector<float> in(height * lane_count), out(height * lane_count);
      for (std::size_t y = 0; y < height; ++y)
        std::copy_n(image.pixels().data() + y * floats + x, floats - x, in.data() + y * lane_count);
      slide<Operation>(in.data(), lane_count, image.height(), radius.y, edge, buffer, out.data());
      for (std::size_t y = 0; y < height; ++y)
        std::copy_n(out.data() + y * lane_count, floats - x, down.pixels().data() + y * floats + x);
    });
  if (radius.x == 0) return down;

  parallel_for((height + lane_count - 1) / lane_count, [&](std::size_t bundle) {
    std::vector<Lanes> buffer = tails(radius.x);
    const std::size_t y = bundle * lane_count, rows = std::min(lane_count, height - y);
    std::vector<float> in(floats * lane_count), out(floats * lane_count);
    float* corner = down.pixels().data() + y * floats;
    std::size_t x = 0;
    if (rows == lane_count)
      for (; x + lane_count <= floats; x += lane_count)
        transpose_8x8(corner + x, floats, in.data() + x * lane_count, lane_count);
    for (std::size_t i = x; i < floats; ++i)
      for (std::size_t r = 0; r < rows; ++r) in[i * lane_count + r] = corner[r * floats + i];
    for (std::size_t c = 0; c < image.channel_count(); ++c)
      slide<Operation>(in.data() + c * lane_count, image.channel_count() * lane_count, image.width(), radius.x, edge,
                       buffer, out.data() + c * lane_count);
    for (std::size_t i = 0; i < x; i += lane_count)
      transpose_8x8(out.data() + i * lane_count, lane_count, corner + i, floats);
    for (std::size_t i = x; i < floats; ++i)
      for (std::size_t r = 0; r < rows; ++r) corner[r * floats + i] = out[i * lane_count + r];
  });
  return down;
}

}  // namespace

Image slid(const Image& image, Vec2i radius, WindowOperation operation, EdgeMode edge) {
  constexpr int most = 65536;
  if (radius.x < 0 || radius.y < 0 || radius.x > most || radius.y > most)
    throw Error("a window's radius must be from 0 to " + std::to_string(most));
  switch (operation) {
    case WindowOperation::sum: return slid_by<Sum>(image, radius, edge);
    case WindowOperation::least: return slid_by<Least>(image, radius, edge);
    case WindowOperation::greatest: break;
  }
  return slid_by<Greatest>(image, radius, edge);
}

}  // namespace lambert
