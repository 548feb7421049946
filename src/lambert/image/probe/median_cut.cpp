#include "lambert/image/probe/median_cut.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace lambert::probe {
namespace {

class PowerTable {
 public:
  explicit PowerTable(const Probe& probe)
      : image_(probe.charts.front()), measure_(texel_measure(probe)), columns_(image_.width() + 1) {
    sums_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(image_.height() + 1));
    for (int y = 0; y < image_.height(); ++y) {
      double row = 0;
      for (int x = 0; x < image_.width(); ++x) {
        row += static_cast<double>(std::max(0.0f, luminance(image_.rgb(x, y))) * omega(x, y));
        at(x + 1, y + 1) = at(x + 1, y) + row;
      }
    }
  }
  double sum(const Window& w) const {
    return at(w.x + w.width, w.y + w.height) - at(w.x, w.y + w.height) - at(w.x + w.width, w.y) + at(w.x, w.y);
  }
  float omega(int x, int y) const {
    return measure_.solid_angle[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                                static_cast<std::size_t>(x)];
  }

 private:
  double& at(int x, int y) { return sums_[static_cast<std::size_t>(y * columns_ + x)]; }
  double at(int x, int y) const { return sums_[static_cast<std::size_t>(y * columns_ + x)]; }
  const Image& image_;
  TexelMeasure measure_;
  int columns_;
  std::vector<double> sums_;
};

Window first_part(const Window& w, bool across, int size) {
  return across ? Window{w.x, w.y, size, w.height} : Window{w.x, w.y, w.width, size};
}
Window rest(const Window& w, bool across, int size) {
  return across ? Window{w.x + size, w.y, w.width - size, w.height} : Window{w.x, w.y + size, w.width, w.height - size};
}

/// Where the two parts' powers are most alike.
int best_cut(const PowerTable& table, const Window& w, bool across) {
  const double half = 0.5 * table.sum(w);
  int low = 1, high = (across ? w.width : w.height) - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (table.sum(first_part(w, across, middle)) < half)
      low = middle + 1;
    else
      high = middle;
  }
  const auto error = [&](int cut) { return std::abs(table.sum(first_part(w, across, cut)) - half); };
  return low > 1 && error(low - 1) < error(low) ? low - 1 : low;
}

}  // namespace

std::vector<CutLight> median_cut(const Probe& probe, int count) {
  if (!std::holds_alternative<LatLong>(probe.projection)) throw Error("median cut works on lat-long maps");
  const Image& image = probe.charts.front();
  const PowerTable table(probe);
  struct Part {
    double power;
    std::size_t order;  // older ones first, where powers are equal
    Window window;
    bool operator<(const Part& o) const { return power != o.power ? power < o.power : order > o.order; }
  };
  std::priority_queue<Part> parts;
  std::vector<Window> whole;
  std::size_t order = 0;
  const auto add = [&](const Window& w) {
    const double power = table.sum(w);
    if (w.width * w.height > 1 && power > 0)
      parts.push({power, order++, w});
    else
      whole.push_back(w);
  };
  add({0, 0, image.width(), image.height()});
  while (!parts.empty() && parts.size() + whole.size() < static_cast<std::size_t>(std::max(1, count))) {
    const Window w = parts.top().window;
    parts.pop();
    // The width of a rectangle shrinks towards the poles.
    const auto middle = static_cast<double>(w.y) + 0.5 * w.height;
    const double shrink = std::sin(std::numbers::pi * middle / image.height());
    const double width = w.width * shrink * 2 * image.height() / image.width();
    const bool across = w.height == 1 || (w.width > 1 && width >= w.height);
    const int cut = best_cut(table, w, across);
    add(first_part(w, across, cut)), add(rest(w, across, cut));
  }
  for (; !parts.empty(); parts.pop()) whole.push_back(parts.top().window);

  std::vector<CutLight> lights;
  for (const Window& w : whole) {
    double towards[3] = {}, e[3] = {};
    for (int y = w.y; y < w.y + w.height; ++y)
      for (int x = w.x; x < w.x + w.width; ++x) {
        const Rgb c = image.rgb(x, y);
        const Vec3 m = texel_moment(probe, 0, x, y);
        const auto l = static_cast<double>(std::max(luminance(c), 1e-20f));
        for (int k = 0; k < 3; ++k) {
          towards[k] += l * static_cast<double>(m[k]);
          e[k] += static_cast<double>(c[k]) * static_cast<double>(table.omega(x, y));
        }
      }
    const double size = std::hypot(towards[0], towards[1], towards[2]);
    const Vec3 d = size > 0 ? Vec3(Vec3d(towards[0], towards[1], towards[2]) / size) : Vec3(0, 1, 0);
    lights.push_back({d, Rgb(static_cast<float>(e[0]), static_cast<float>(e[1]), static_cast<float>(e[2])), w});
  }
  std::stable_sort(lights.begin(), lights.end(), [](const CutLight& a, const CutLight& b) {
    return luminance(a.irradiance) > luminance(b.irradiance);
  });
  return lights;
}

}  // namespace lambert::probe
