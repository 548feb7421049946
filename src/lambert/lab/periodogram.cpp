#include "lambert/lab/periodogram.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace lambert::lab {
namespace {

/// exp(-2πi k x) for k = -reach … reach.
std::vector<std::complex<double>> waves(double x, int reach) {
  std::vector<std::complex<double>> w;
  for (int k = -reach; k <= reach; ++k) w.push_back(std::polar(1.0, -2 * std::numbers::pi * k * x));
  return w;
}

}  // namespace

std::vector<double> periodogram(std::span<const Vec2> points, int reach) {
  const auto side = static_cast<std::size_t>(2 * reach + 1);
  std::vector<double> real(side * side), imaginary(side * side), power(side * side);
  for (const Vec2 p : points) {
    const auto across = waves(static_cast<double>(p.x), reach), down = waves(static_cast<double>(p.y), reach);
    for (std::size_t y = 0; y < side; ++y) {
      const double re = down[y].real(), im = down[y].imag();
      for (std::size_t x = 0; x < side; ++x) {
        real[y * side + x] += across[x].real() * re - across[x].imag() * im;
        imaginary[y * side + x] += across[x].real() * im + across[x].imag() * re;
      }
    }
  }
  const double n = points.empty() ? 1 : static_cast<double>(points.size());
  for (std::size_t i = 0; i < power.size(); ++i) power[i] = (real[i] * real[i] + imaginary[i] * imaginary[i]) / n;
  return power;
}

std::vector<double> radial_mean(std::span<const double> power, int reach) {
  std::vector<double> mean(static_cast<std::size_t>(reach) + 1), count(mean.size());
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      const auto r = static_cast<std::size_t>(std::lround(std::hypot(x, y)));
      if (r > static_cast<std::size_t>(reach)) continue;
      mean[r] += power[static_cast<std::size_t>((y + reach) * (2 * reach + 1) + x + reach)];
      ++count[r];
    }
  for (std::size_t r = 0; r < mean.size(); ++r) mean[r] /= count[r];
  return mean;
}

}  // namespace lambert::lab
