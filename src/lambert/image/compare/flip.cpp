#include "lambert/image/compare/flip.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/compare/flip_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace lambert::compare {
namespace {

/// f(x) for x = -radius … radius.
template <class F>
std::vector<double> tabulated(int radius, F f) {
  std::vector<double> kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(f(static_cast<double>(x)));
  return kernel;
}

using Planes = std::array<Plane, 3>;

Planes empty_planes(int width, int height) {
  return {Plane(width, height), Plane(width, height), Plane(width, height)};
}

/// The image in the opponent space YCxCz, each row by `shown` of its pixels.
Planes opponent_planes(const Image& image, const std::function<Rgb(Rgb)>& shown) {
  Planes planes = empty_planes(image.width(), image.height());
  parallel_for(static_cast<std::size_t>(image.height()), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    for (int x = 0; x < image.width(); ++x) {
      const Rgb c = image.rgb(x, y);
      const Vec3 o = opponent(is_finite(c) ? clamp(shown(c), 0, 1) : Rgb());
      for (int k = 0; k < 3; ++k) planes[static_cast<std::size_t>(k)].row(y)[static_cast<std::size_t>(x)] = o[k];
    }
  });
  return planes;
}

/// A sum of two Gaussians in degrees of visual angle, a sqrt(pi / b) exp(-pi² x² / b) (table 1 of the paper).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
constexpr double widest = 0.04;

/// The contrast sensitivity of an eye as a low-pass filter of each opponent channel (section 4.1.1).
Plane seen(const Plane& plane, const Sensitivity& s, double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi_squared)) * pixels_per_degree));
  const auto gaussian = [&](double b) {
    return tabulated(
        radius, [&](double x) { return std::exp(-pi_squared * x * x / (pixels_per_degree * pixels_per_degree * b)); });
  };
  const auto total = [](const std::vector<double>& k) {
    const double sum = std::accumulate(k.begin(), k.end(), 0.0);
    return sum * sum;
  };
  const std::vector<double> first = gaussian(s.b1), second = gaussian(s.b2);
  const double w1 = s.a1 * std::sqrt(pi_double / s.b1), w2 = s.a2 * std::sqrt(pi_double / s.b2);
  const double all = w1 * total(first) + w2 * total(second);
  Plane result = filtered(plane, first, first);
  const auto f1 = static_cast<float>(w1 / all), f2 = static_cast<float>(w2 / all);
  for (float& v : result.values) v *= f1;
  if (f2 > 0) {
    const Plane more = filtered(plane, second, second);
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] += f2 * more.values[i];
  }
  return result;
}

Planes seen(const Planes& planes, double pixels_per_degree) {
  return {seen(planes[0], sensitivities[0], pixels_per_degree), seen(planes[1], sensitivities[1], pixels_per_degree),
          seen(planes[2], sensitivities[2], pixels_per_degree)};
}

/// How strong edges and points are, in the achromatic channel scaled to [0, 1] (section 4.2).
struct Features {
  Plane edge, point;
};
Features features_of(const Plane& y, double pixels_per_degree) {
  Plane unit(y.width, y.height);
  std::transform(y.values.begin(), y.values.end(), unit.values.begin(), [](float v) { return (v + 16) / 116; });
  const double sigma = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> smooth = tabulated(radius, [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); });
  const double sum = std::accumulate(smooth.begin(), smooth.end(), 0.0);
  for (double& w : smooth) w /= sum;
  // Positive weights sum to 1 and negative ones to -1: a step or a point of full contrast answers with 1.
  const auto balanced = [](std::vector<double> kernel) {
    double positive = 0, negative = 0;
    for (const double w : kernel) (w > 0 ? positive : negative) += w;
    for (double& w : kernel) w /= w > 0 ? positive : -negative;
    return kernel;
  };
  const auto edge = balanced(tabulated(radius, [&](double x) { return -x * std::exp(-x * x / (2 * sigma * sigma)); }));
  const auto point = balanced(tabulated(
      radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * std::exp(-x * x / (2 * sigma * sigma)); }));
  const auto strength = [&](const std::vector<double>& kernel) {
    Plane across = filtered(unit, kernel, smooth);
    const Plane down = filtered(unit, smooth, kernel);
    for (std::size_t i = 0; i < across.values.size(); ++i)
      across.values[i] = std::hypot(across.values[i], down.values[i]);
    return across;
  };
  return {strength(edge), strength(point)};
}

Flip flip_shown(const Image& a, const Image& b, const FlipSettings& settings, const std::function<Rgb(Rgb)>& shown) {
  if (a.width() != b.width() || a.height() != b.height()) throw Error("the sizes differ");
  const double ppd = settings.pixels_per_degree;
  if (!(ppd >= 1) || !(ppd <= 1000)) throw Error("the pixels per degree must be from 1 to 1000");
  const Planes opponent_a = opponent_planes(a, shown), opponent_b = opponent_planes(b, shown);
  const Planes seen_a = seen(opponent_a, ppd), seen_b = seen(opponent_b, ppd);
  const Features features_a = features_of(opponent_a[0], ppd), features_b = features_of(opponent_b[0], ppd);

  Flip result{.mean = 0, .map = Plane(a.width(), a.height())};
  parallel_for(static_cast<std::size_t>(a.height()), [&](std::size_t row) {
    const std::size_t begin = row * static_cast<std::size_t>(a.width());
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(a.width()); ++i) {
      const auto lab = [&](const Planes& p) { return hunt_lab({p[0].values[i], p[1].values[i], p[2].values[i]}); };
      const float colour = colour_error(lab(seen_a), lab(seen_b));
      const float feature = std::max(std::abs(features_a.edge.values[i] - features_b.edge.values[i]),
                                     std::abs(features_a.point.values[i] - features_b.point.values[i]));
      const float feature_error = std::sqrt(std::min(1.0f, feature / std::sqrt(2.0f)));
      result.map.values[i] = std::pow(colour, 1 - feature_error);
    }
  });
  for (const float v : result.map.values) result.mean += static_cast<double>(v);
  result.mean /= static_cast<double>(result.map.values.size());
  return result;
}

/// The fit of the ACES curve, x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), with its exposure of 0.6.
Rgb aces(Rgb c) {
  const auto curve = [](float x) {
    x = 0.6f * std::clamp(x, 0.0f, 1e9f);  // far above white, its square still finite
    return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
  };
  return {curve(c.r), curve(c.g), curve(c.b)};
}

/// The x at which the curve is t: the positive root of (2.51 - 2.43 t) x² + (0.03 - 0.59 t) x - 0.14 t = 0.
double aces_inverse(double t) {
  const double a = 2.51 - 2.43 * t, b = 0.03 - 0.59 * t, c = -0.14 * t;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a) / 0.6;
}

}  // namespace

Flip flip(const Image& a, const Image& b, const FlipSettings& settings) {
  return flip_shown(a, b, settings, [](Rgb c) { return c; });
}

Flip hdr_flip(const Image& image, const Image& reference, const FlipSettings& settings) {
  std::vector<float> luminances;
  for (int y = 0; y < reference.height(); ++y)
    for (int x = 0; x < reference.width(); ++x) {
      const float value = luminance(reference.rgb(x, y));
      luminances.push_back(std::isfinite(value) ? std::max(value, 0.0f) : 0.0f);
    }
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  // A reference that is black by half, or wholly, still gets exposures to look at.
  const double brightest = std::max(1e-4, static_cast<double>(*std::max_element(middle, luminances.end())));
  const double median = std::clamp(static_cast<double>(*middle), brightest * 0x1p-16, brightest);
  const double white = aces_inverse(0.85);
  const double start = std::log2(white / brightest), stop = std::log2(white / median);
  const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));

  Flip result{.mean = 0, .map = Plane(reference.width(), reference.height())};
  for (int i = 0; i < count; ++i) {
    const auto scale = static_cast<float>(std::exp2(start + (stop - start) * i / (count - 1)));
    const Flip at = flip_shown(image, reference, settings, [scale](Rgb c) { return aces(c * scale); });
    for (std::size_t p = 0; p < at.map.values.size(); ++p)
      result.map.values[p] = std::max(result.map.values[p], at.map.values[p]);
  }
  for (const float v : result.map.values) result.mean += static_cast<double>(v);
  result.mean /= static_cast<double>(result.map.values.size());
  return result;
}

}  // namespace lambert::compare
