#include "lambert/image/probe/find_ball.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambert::probe {
namespace {

/// One number per pixel.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;
  float at(int x, int y) const {
    x = std::clamp(x, 0, width - 1), y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  /// Bilinear; pixel centres lie at halves.
  float read(Vec2d p) const {
    const double x = p.x - 0.5, y = p.y - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const auto s = static_cast<float>(x - i), t = static_cast<float>(y - j);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }
  bool holds(Vec2d p) const { return p.x >= 1 && p.y >= 1 && p.x <= width - 1 && p.y <= height - 1; }
};

/// Brightness as the eye has it, of pictures of any exposure: log(1 + L / median).
Plane brightness(const Image& image) {
  Plane p{image.width(), image.height(), {}};
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) {
      const float l = luminance(image.rgb(x, y));
      p.values.push_back(std::isfinite(l) && l > 0 ? l : 0);
    }
  std::vector<float> lit;
  for (const float v : p.values)
    if (v > 0) lit.push_back(v);
  if (lit.empty()) return p;
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  for (float& v : p.values) v = std::log1p(4 * v / *middle);
  return p;
}

Plane halved(const Plane& p) {
  Plane h{std::max(1, p.width / 2), std::max(1, p.height / 2), {}};
  for (int y = 0; y < h.height; ++y)
    for (int x = 0; x < h.width; ++x)
      h.values.push_back(
          0.25f * (p.at(2 * x, 2 * y) + p.at(2 * x + 1, 2 * y) + p.at(2 * x, 2 * y + 1) + p.at(2 * x + 1, 2 * y + 1)));
  return h;
}

/// The slope at a pixel (Scharr's operator).
Vec2 slope(const Plane& p, int x, int y) {
  const auto across = [&](int j) { return p.at(x + 1, y + j) - p.at(x - 1, y + j); };
  const auto down = [&](int i) { return p.at(x + i, y + 1) - p.at(x + i, y - 1); };
  return {(3 * across(-1) + 10 * across(0) + 3 * across(1)) / 32, (3 * down(-1) + 10 * down(0) + 3 * down(1)) / 32};
}

struct Edge {
  Vec2d at;
  Vec2 normal;  // unit
};

/// The strongest edges, at most `most`.
std::vector<Edge> edges_of(const Plane& p, std::size_t most, float& strong) {
  struct Found {
    Edge edge;
    float strength;
  };
  std::vector<Found> found;
  for (int y = 1; y + 1 < p.height; ++y)
    for (int x = 1; x + 1 < p.width; ++x) {
      const Vec2 g = slope(p, x, y);
      const float strength = length(g);
      if (strength > 1e-3f) found.push_back({{Vec2d(x + 0.5, y + 0.5), g / strength}, strength});
    }
  const auto by_strength = [](const Found& a, const Found& b) { return a.strength > b.strength; };
  std::stable_sort(found.begin(), found.end(), by_strength);
  if (found.size() > most) found.resize(most);
  strong = found.empty() ? 0 : found[found.size() / 2].strength;
  std::vector<Edge> edges;
  for (const Found& f : found) edges.push_back(f.edge);
  return edges;
}

/// How much of the circle has an edge along it: the mean over its places of how strong the slope is (a fifth of a
/// strong edge counts in full: an outline is seldom strong, but whole) and of how nearly it stands across the circle.
/// Places out of the picture do not count, up to a half.
double score(const Plane& p, Vec2d centre, double radius, float strong) {
  constexpr int places = 96;
  double sum = 0;
  int inside = 0;
  for (int i = 0; i < places; ++i) {
    const double angle = 2 * std::numbers::pi * i / places;
    const Vec2d n(std::cos(angle), std::sin(angle));
    const Vec2d at = centre + radius * n;
    if (!p.holds(at)) continue;
    ++inside;
    const Vec2 g = slope(p, static_cast<int>(at.x), static_cast<int>(at.y));
    const float across = std::abs(dot(g, Vec2(n))), all = length(g);
    if (all > 0) sum += static_cast<double>(std::min(1.0f, 5 * across / strong) * sqr(across / all));
  }
  return sum / std::max(inside, places / 2);
}

std::optional<BallCircle> best_circle(const Plane& p, const FindBallSettings& s) {
  float strong = 0;
  const auto pixels = static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
  const std::vector<Edge> edges = edges_of(p, std::clamp<std::size_t>(pixels / 12, 64, 6000), strong);
  if (edges.size() < 16 || !(strong > 0)) return std::nullopt;
  const double shorter = std::min(p.width, p.height);
  BallCircle best;
  for (std::uint64_t i = 0; i < 60000; ++i) {
    const auto pick = [&](std::uint64_t k) { return edges[hash_values(i, k) % edges.size()]; };
    const Edge a = pick(1), b = pick(2);
    const Vec2d na(a.normal), nb(b.normal);
    const double across = na.x * nb.y - na.y * nb.x;
    if (std::abs(across) < 0.25) continue;
    const Vec2d ab = b.at - a.at;
    const double ta = (ab.x * nb.y - ab.y * nb.x) / across;
    const Vec2d centre = a.at + ta * na;
    const double ra = std::abs(ta), rb = length(b.at - centre);
    if (std::abs(ra - rb) > 0.06 * ra + 1) continue;
    const double radius = 0.5 * (ra + rb);
    if (radius < s.smallest * shorter || radius > s.largest * shorter) continue;
    const double found = score(p, centre, radius, strong);
    if (found > best.coverage) best = {centre, radius, found, 0};
  }
  if (!(best.coverage > 0)) return std::nullopt;
  for (double h = 2; h > 0.2; h *= 0.5)  // to the top of the hill
    for (int round = 0; round < 20; ++round) {
      BallCircle next = best;
      for (int k = 0; k < 6; ++k) {
        BallCircle t = best;
        const double step = k % 2 ? -h : h;
        (k / 2 == 0 ? t.centre.x : k / 2 == 1 ? t.centre.y : t.radius) += step;
        if ((t.coverage = score(p, t.centre, t.radius, strong)) > next.coverage) next = t;
      }
      if (!(next.coverage > best.coverage)) break;
      best = next;
    }
  return best;
}

/// The place of the largest step along the normal near the circle, to parts of a pixel.
std::optional<Vec2d> edge_near(const Plane& p, Vec2d centre, double radius, Vec2d n, double reach, float least) {
  const double step = 0.5;
  const int count = static_cast<int>(std::ceil(reach / step));
  const auto at = [&](int k) {
    const Vec2d q = centre + (radius + k * step) * n;
    return std::abs(p.read(q + 0.75 * n) - p.read(q - 0.75 * n));
  };
  if (!p.holds(centre + (radius + reach + 1) * n) || !p.holds(centre + (radius - reach - 1) * n)) return std::nullopt;
  int best = -count;
  for (int k = -count; k <= count; ++k)
    if (at(k) > at(best)) best = k;
  const auto l = static_cast<double>(at(best - 1)), m = static_cast<double>(at(best)),
             r = static_cast<double>(at(best + 1));
  if (m < static_cast<double>(least)) return std::nullopt;
  const double curve = l - 2 * m + r, offset = curve < 0 ? std::clamp(0.5 * (l - r) / curve, -1.0, 1.0) : 0;
  return centre + (radius + (best + offset) * step) * n;
}

/// Gauss-Newton on Σ (|p - c| - r)², outliers by their distance left out.
BallCircle fit(const Plane& p, BallCircle circle, double reach, float least) {
  constexpr int places = 360;
  for (int round = 0; round < 6; ++round, reach = std::max(2.0, 0.6 * reach)) {
    std::vector<Vec2d> points;
    for (int i = 0; i < places; ++i) {
      const double angle = 2 * std::numbers::pi * i / places;
      if (const auto e = edge_near(p, circle.centre, circle.radius, {std::cos(angle), std::sin(angle)}, reach, least))
        points.push_back(*e);
    }
    if (points.size() < 12) return circle;
    for (int i = 0; i < 12; ++i) {
      std::vector<double> distances;
      for (const Vec2d q : points) distances.push_back(std::abs(length(q - circle.centre) - circle.radius));
      std::vector<double> sorted = distances;
      std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
      const double limit = std::max(0.3, 2.5 * sorted[sorted.size() / 2]);
      glm::dmat3 normal(0);
      Vec3d right(0);
      double sum = 0;
      int used = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (distances[k] > limit) continue;
        const Vec2d out = points[k] - circle.centre;
        const double l = length(out);
        const Vec3d row(-out.x / l, -out.y / l, -1);
        const double error = l - circle.radius;
        normal += glm::outerProduct(row, row);
        right -= error * row;
        sum += error * error, ++used;
      }
      if (used < 8 || std::abs(glm::determinant(normal)) < 1e-9) break;
      const Vec3d move = glm::inverse(normal) * right;
      circle.centre += Vec2d(move.x, move.y), circle.radius += move.z;
      circle.residual = std::sqrt(sum / used), circle.coverage = static_cast<double>(used) / places;
      if (length(move) < 1e-6) break;
    }
  }
  return circle;
}

}  // namespace

std::optional<BallCircle> find_ball(const Image& image, const FindBallSettings& settings) {
  std::vector<Plane> levels{brightness(image)};
  while (std::min(levels.back().width, levels.back().height) > 320) levels.push_back(halved(levels.back()));
  auto found = best_circle(levels.back(), settings);
  if (!found || found->coverage < 0.3) return std::nullopt;
  float strong = 0;
  edges_of(levels.back(), 2000, strong);
  for (std::size_t level = levels.size(); level-- > 0;) {
    *found = fit(levels[level], *found, level + 1 == levels.size() ? 3.0 : 4.0, 0.15f * strong);
    if (level > 0) found->centre *= 2.0, found->radius *= 2, found->residual *= 2;
  }
  if (found->coverage < settings.least_coverage || !(found->radius > 1)) return std::nullopt;
  // Edges that are there by chance, as in noise, are spread evenly over the 2 pixels to either side.
  if (found->residual > 0.75 + 0.004 * found->radius) return std::nullopt;
  return found;
}

double part_in_picture(const Image& image, const BallCircle& circle) {
  constexpr int places = 360;
  int inside = 0;
  for (int i = 0; i < places; ++i) {
    const double angle = 2 * std::numbers::pi * i / places;
    const Vec2d at = circle.centre + circle.radius * Vec2d(std::cos(angle), std::sin(angle));
    inside += at.x >= -0.5 && at.y >= -0.5 && at.x <= image.width() + 0.5 && at.y <= image.height() + 0.5;
  }
  return static_cast<double>(inside) / places;
}

Image crop_ball(const Image& image, const BallCircle& circle, int size) {
  const int n = size > 0 ? size : std::max(1, static_cast<int>(std::lround(2 * circle.radius)));
  Image out(n, n, image.channels());
  out.metadata = image.metadata;
  const double scale = 2 * circle.radius / n;
  const int samples = std::max(1, static_cast<int>(std::ceil(2 * scale - 1.5)));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      for (int k = 0; k < samples * samples; ++k) {
        const Vec2d in_pixel((k % samples + 0.5) / samples, (k / samples + 0.5) / samples);
        const Vec2d p = circle.centre - circle.radius + scale * (Vec2d(x, y) + in_pixel) - 0.5;
        const int i = static_cast<int>(std::floor(p.x)), j = static_cast<int>(std::floor(p.y));
        const auto s = static_cast<float>(p.x - i), t = static_cast<float>(p.y - j);
        for (int corner = 0; corner < 4; ++corner) {
          const int cx = i + (corner & 1), cy = j + (corner >> 1);
          if (cx < 0 || cy < 0 || cx >= image.width() || cy >= image.height()) continue;
          const float w =
              ((corner & 1) ? s : 1 - s) * ((corner >> 1) ? t : 1 - t) / static_cast<float>(samples * samples);
          for (std::size_t c = 0; c < image.channel_count(); ++c) out.at(x, y, c) += w * image.at(cx, cy, c);
        }
      }
  return out;
}

Rgb ball_reflectivity(const Image& image, const Window& reflected, const Window& direct) {
  const auto mean = [&](const Window& w) {
    if (w.x < 0 || w.y < 0 || w.width <= 0 || w.height <= 0 || w.x > image.width() - w.width ||
        w.y > image.height() - w.height)
      throw Error("the window " + std::to_string(w.x) + "," + std::to_string(w.y) + "," + std::to_string(w.width) +
                  "," + std::to_string(w.height) + " does not lie in the picture of " + std::to_string(image.width()) +
                  "x" + std::to_string(image.height()));
    double sum[3] = {};
    for (int y = w.y; y < w.y + w.height; ++y)
      for (int x = w.x; x < w.x + w.width; ++x)
        for (int k = 0; k < 3; ++k) sum[k] += static_cast<double>(image.rgb(x, y)[k]);
    const double count = static_cast<double>(w.width) * w.height;
    return Rgb(static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
               static_cast<float>(sum[2] / count));
  };
  const Rgb seen = mean(reflected), patch = mean(direct);
  if (!(min_component(patch) > 0) || !is_finite(patch) || !is_finite(seen))
    throw Error("the patch seen directly is black, or one of the two is not finite");
  return seen / patch;
}

}  // namespace lambert::probe
