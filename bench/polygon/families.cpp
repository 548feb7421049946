#include "families.h"

#include <cmath>
#include <numbers>
#include <random>

namespace lambert::bench {
namespace {

using polygon::Ring;
using polygon::Rings;
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vec2d polar(Vec2d centre, double radius, double angle) {
  return centre + Vec2d(radius * std::cos(angle), radius * std::sin(angle));
}

template <typename Radius>
Ring around(Vec2d centre, std::size_t vertices, Radius radius) {
  Ring ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
    ring.push_back(polar(centre, radius(angle), angle));
  }
  return ring;
}

Pair stars(std::size_t edges) {
  Random random(1);
  const auto radius = [&](double) { return uniform(random, 0.5, 1); };
  return {{around({0, 0}, edges / 2, radius)}, {around({0.03, 0.02}, edges / 2, radius)}};
}

Ring blob(Vec2d centre, double phase, std::size_t vertices) {
  return around(centre, vertices, [&](double angle) {
    return 0.6 + 0.15 * std::sin(3 * angle + phase) + 0.1 * std::sin(7 * angle + 2 * phase) +
           0.05 * std::sin(19 * angle);
  });
}

Pair blobs(std::size_t edges) {
  return {{blob({0, 0}, 0, edges / 2)}, {blob({0.2, 0.1}, 1, edges / 2)}};
}

/// A spine at y = 0 and teeth up to y = 1; `flipped` hangs from y = 1.2 instead.
Ring comb(std::size_t teeth, double shift, bool flipped, Random& random) {
  Ring ring;
  const double step = 1 / static_cast<double>(teeth);
  for (std::size_t i = 0; i < teeth; ++i) {
    const double x = shift + static_cast<double>(i) * step, top = uniform(random, 0.7, 1);
    ring.emplace_back(x, 0.1);
    ring.emplace_back(x + 0.2 * step, top);
    ring.emplace_back(x + 0.5 * step, top);
    ring.emplace_back(x + 0.8 * step, 0.1);
  }
  ring.emplace_back(1 + shift, 0);
  ring.emplace_back(shift, 0);
  if (flipped) {
    for (Vec2d& p : ring) p.y = 1.15 - p.y;
  }
  return ring;
}

Pair combs(std::size_t edges) {
  Random random(2);
  const std::size_t teeth = edges / 8;
  return {{comb(teeth, 0, false, random)}, {comb(teeth, 0.37 / static_cast<double>(teeth), true, random)}};
}

Rings square_grid(std::size_t count, Random& random) {
  Rings squares;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double step = 1 / static_cast<double>(side);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d corner = step * (Vec2d(static_cast<double>(i % side), static_cast<double>(i / side)) +
                                 Vec2d(uniform(random, 0, 0.3), uniform(random, 0, 0.3)));
    const double size = step * uniform(random, 0.4, 0.65);
    squares.push_back({corner, corner + Vec2d(size, 0), corner + Vec2d(size, size), corner + Vec2d(0, size)});
  }
  return squares;
}

Pair squares(std::size_t edges) {
  Random random(3);
  Rings subject = square_grid(edges / 8, random), clip = square_grid(edges / 8, random);
  return {std::move(subject), std::move(clip)};
}

/// Midpoint displacement of the radius.
Ring coast(Vec2d centre, std::size_t vertices, Random& random) {
  std::vector<double> radii{0.7};
  for (double roughness = 0.2; radii.size() < vertices; roughness *= 0.6) {
    std::vector<double> finer;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double next = radii[polygon::next_index(i, radii.size())];
      finer.push_back(radii[i]);
      finer.push_back(0.5 * (radii[i] + next) + uniform(random, -roughness, roughness));
    }
    radii = std::move(finer);
  }
  const double scale = static_cast<double>(radii.size()) / (2 * std::numbers::pi);
  return around(centre, vertices, [&](double angle) {
    return radii[std::min(static_cast<std::size_t>(std::llround(angle * scale)), radii.size() - 1)];
  });
}

Pair coasts(std::size_t edges) {
  Random random(4);
  Ring subject = coast({0, 0}, edges / 2, random), clip = coast({0.1, 0.05}, edges / 2, random);
  return {{std::move(subject)}, {std::move(clip)}};
}

}  // namespace

std::vector<Family> families() {
  return {{"stars", stars}, {"blobs", blobs}, {"combs", combs}, {"squares", squares}, {"coasts", coasts}};
}

std::size_t edge_count(const Rings& rings) {
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.size();
  return count;
}

}  // namespace lambert::bench
