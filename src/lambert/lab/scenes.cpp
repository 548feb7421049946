#include "lambert/lab/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lambert::lab {
namespace {

constexpr double pi_d = std::numbers::pi;
double fraction(double v) { return v - std::floor(v); }

}  // namespace

Scene comb(const Comb& c) {
  return [c](Vec2d p) {
    const double tooth = p.x / c.pitch, y = (p.y - c.top) / c.height;
    if (tooth < 0 || tooth >= c.teeth || y < 0 || y >= 1) return Rgb();
    return Rgb(std::abs(fraction(tooth) - 0.5) < 0.5 * y ? 1.0f : 0.0f);
  };
}

double alias_frequency(double frequency, double rate) {
  return std::abs(frequency - rate * std::round(frequency / rate));
}

double alias_period(double period) {
  const double f = alias_frequency(1 / period, 1);
  return f > 0 ? 1 / f : std::numeric_limits<double>::infinity();
}

Scene zone_plate(int width, int height) {
  const Vec2d centre(0.5 * width, 0.5 * height);
  return [centre, width](Vec2d p) {
    const Vec2d d = p - centre;
    return Rgb(static_cast<float>(0.5 + 0.5 * std::cos(pi_d * dot(d, d) / width)));
  };
}

Scene checkered_plane(int width, int height) {
  const double horizon = height / 3.0, middle = 0.5 * width, scale = 0.9 * height;
  return [=](Vec2d p) {
    const double depth = p.y - horizon;
    if (depth <= 0) return Rgb(0.45f, 0.62f, 0.85f);
    const double z = scale / depth, x = (p.x - middle) * z / scale * 4;
    const bool dark = (static_cast<long long>(std::floor(x)) + static_cast<long long>(std::floor(3 * z))) % 2 != 0;
    return dark ? Rgb(0.03f) : Rgb(0.85f, 0.8f, 0.7f);
  };
}

Scene moire(const Lines& a, const Lines& b) {
  const auto dark = [](const Lines& l, Vec2d p) {
    return fraction((p.x * std::cos(l.angle) + p.y * std::sin(l.angle) - l.shift) / l.period) < 0.5;
  };
  return [=](Vec2d p) { return Rgb(dark(a, p) || dark(b, p) ? 0.02f : 1.0f); };
}

Scene small_details(int width, int height) {
  const double w = width, h = height;
  return [w, h](Vec2d p) {
    // Nearly level lines a third of a pixel thick.
    for (int i = 0; i < 6; ++i) {
      const double y = h * (0.07 + 0.05 * i) + p.x * 0.03 * (i + 1);
      if (std::abs(p.y - y) < 1.0 / 6) return Rgb(1, 0.9f, 0.5f);
    }
    // Dots of half a pixel, 5.3 pixels apart.
    if (p.y > 0.55 * h && p.y < 0.75 * h) {
      const Vec2d cell(fraction(p.x / 5.3) - 0.5, fraction(p.y / 5.3) - 0.5);
      if (5.3 * std::hypot(cell.x, cell.y) < 0.25) return Rgb(0.5f, 0.9f, 1);
    }
    // A wedge that ends in a point.
    if (p.y > 0.8 * h && p.y < 0.95 * h && std::abs(p.y - 0.875 * h) < 2.5 * (1 - p.x / w)) return Rgb(1, 0.4f, 0.4f);
    return Rgb(0.01f, 0.012f, 0.02f);
  };
}

}  // namespace lambert::lab
