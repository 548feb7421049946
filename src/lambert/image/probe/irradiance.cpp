#include "lambert/image/probe/irradiance.h"

#include "lambert/base/parallel.h"
#include "lambert/image/probe/disk.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace lambert::probe {
namespace {

using Node = Irradiance::Node;

constexpr float widest = 0.03f;  // half angle of a leaf, radians
constexpr int most_leaves = 1 << 19, deepest = 11;

/// Some texels of a chart, or a part of a single one.
struct Patch {
  int chart;
  Window texels;
  Cell cell;      // what of the chart they show
  int depth = 0;  // how often the texel was cut in four
};

class Tree {
 public:
  explicit Tree(const Probe& probe) : probe_(probe) {
    const auto leaves = [&] {
      const auto along = [&](int n) { return static_cast<std::int64_t>((n + block_ - 1) / block_); };
      return along(probe.width()) * along(probe.height()) * static_cast<std::int64_t>(probe.charts.size());
    };
    while (leaves() > most_leaves) ++block_;
  }

  /// Patches of some tens of blocks along each side, for threads to take.
  std::vector<Patch> roots() const {
    const int side = 32 * block_;
    std::vector<Patch> patches;
    for (int chart = 0; chart < static_cast<int>(probe_.charts.size()); ++chart)
      for (int y = 0; y < probe_.height(); y += side)
        for (int x = 0; x < probe_.width(); x += side)
          patches.push_back(
              patch(chart, {x, y, std::min(side, probe_.width() - x), std::min(side, probe_.height() - y)}));
    return patches;
  }

  /// Appends the patch and all below it; returns the half angle of its cone.
  float build(const Patch& p, std::vector<Node>& nodes) const {
    const std::size_t at = nodes.size();
    nodes.emplace_back();
    float angle = 0;
    if (p.texels.width <= block_ && p.texels.height <= block_) {
      Node leaf;
      angle = fill(p, leaf);
      if (angle <= widest || p.depth == deepest) {
        nodes[at] = leaf;
        set_radius(nodes[at], angle);
        return angle;
      }
    }
    std::array<std::size_t, 4> children{};
    std::array<float, 4> angles{};
    std::size_t count = 0;
    for (const Patch& part : parts_of(p)) {
      children[count] = nodes.size();
      angles[count++] = build(part, nodes);
    }
    angle = join(nodes, at, {children.data(), count}, angles);
    set_radius(nodes[at], angle);
    return angle;
  }

 private:
  Patch patch(int chart, const Window& w) const {
    const Cell first = texel_cell(probe_, w.x, w.y), last = texel_cell(probe_, w.x + w.width - 1, w.y + w.height - 1);
    return {chart, w, {first.u0, last.u1, first.v0, last.v1}};
  }

  std::vector<Patch> parts_of(const Patch& p) const {
    std::vector<Patch> parts;
    if (p.texels.width == 1 && p.texels.height == 1) {
      if (at_rim(p.cell)) {
        const DiskReach r = disk_reach(probe_.projection, p.cell);
        for (int i = 0; i < 4; ++i) {
          Cell slice = p.cell;
          slice.theta0 = r.theta0 + 0.25 * i * (r.theta1 - r.theta0);
          slice.theta1 = r.theta0 + 0.25 * (i + 1) * (r.theta1 - r.theta0);
          parts.push_back({p.chart, p.texels, slice, p.depth + 1});
        }
        return parts;
      }
      const double u = 0.5 * (p.cell.u0 + p.cell.u1), v = 0.5 * (p.cell.v0 + p.cell.v1);
      for (const Cell& c : {Cell{p.cell.u0, u, p.cell.v0, v}, Cell{u, p.cell.u1, p.cell.v0, v},
                            Cell{p.cell.u0, u, v, p.cell.v1}, Cell{u, p.cell.u1, v, p.cell.v1}})
        parts.push_back({p.chart, p.texels, c, p.depth + 1});
      return parts;
    }
    const Window& w = p.texels;
    const int left = (w.width + 1) / 2, top = (w.height + 1) / 2;
    for (const Window& part :
         {Window{w.x, w.y, left, top}, Window{w.x + left, w.y, w.width - left, top},
          Window{w.x, w.y + top, left, w.height - top}, Window{w.x + left, w.y + top, w.width - left, w.height - top}})
      if (part.width > 0 && part.height > 0) parts.push_back(patch(p.chart, part));
    return parts;
  }

  /// Moments and axis of a leaf; returns the half angle of the cone about its corners.
  float fill(const Patch& p, Node& node) const {
    const Image& image = probe_.charts[static_cast<std::size_t>(p.chart)];
    Vec3d sum(0);
    double solid_angle = 0;
    for (int y = p.texels.y; y < p.texels.y + p.texels.height; ++y)
      for (int x = p.texels.x; x < p.texels.x + p.texels.width; ++x) {
        const Cell cell = p.depth > 0 ? p.cell : texel_cell(probe_, x, y);
        const CellIntegrals i = integrals(probe_.projection, p.chart, cell);
        const Rgb c = image.rgb(x, y);
        for (int k = 0; k < 3; ++k) node.moment[static_cast<std::size_t>(k)] += c[k] * Vec3(i.moment);
        sum += i.moment, solid_angle += i.solid_angle;
      }
    const double size = length(sum);
    if (!(solid_angle > 0)) return 0;             // out of the disk
    if (!(size > 0.99 * solid_angle)) return pi;  // directions that undo each other: corners say nothing
    node.axis = Vec3(sum / size);
    if (p.texels.width == 1 && p.texels.height == 1 && at_rim(p.cell)) {
      const DiskReach r = disk_reach(probe_.projection, p.cell);
      return static_cast<float>(std::hypot(0.5 * (r.theta1 - r.theta0), 0.6 * diagonal(p.cell)));
    }
    float angle = 0;
    for (const Vec2d corner : {Vec2d(p.cell.u0, p.cell.v0), Vec2d(p.cell.u1, p.cell.v0), Vec2d(p.cell.u0, p.cell.v1),
                               Vec2d(p.cell.u1, p.cell.v1)})
      if (const auto d = direction(probe_.projection, {p.chart, on_disk(Vec2(corner))}))
        angle = std::max(angle, between(*d, node.axis));
    return angle;
  }

  bool has_disk() const {
    return std::holds_alternative<MirrorBall>(probe_.projection) || std::holds_alternative<Fisheye>(probe_.projection);
  }
  static double diagonal(const Cell& c) { return 2 * std::hypot(c.u1 - c.u0, c.v1 - c.v0); }
  /// Near the rim a cell is long along the radius, which no side of it need follow: there rings cut it.
  bool at_rim(const Cell& c) const {
    return has_disk() && diagonal(c) < static_cast<double>(widest) && disk_reach(probe_.projection, c).nearest > 0.9;
  }
  /// The corner itself, or what of the disk is nearest to it.
  Vec2 on_disk(Vec2 uv) const {
    const Vec2 p = disk_point(uv);
    const float r = length(p);
    return has_disk() && r > 0.999999f ? disk_uv(p * (0.999999f / r)) : uv;
  }
  /// By the chord: acos has no digits for small angles.
  static float between(Vec3 a, Vec3 b) { return 2 * std::asin(std::min(1.0f, 0.5f * length(a - b))); }

  static float join(std::vector<Node>& nodes, std::size_t at, std::span<const std::size_t> children,
                    const std::array<float, 4>& angles) {
    Node& node = nodes[at];
    for (const std::size_t child : children) {
      for (std::size_t k = 0; k < 3; ++k) node.moment[k] += nodes[child].moment[k];
      node.axis += nodes[child].axis;
    }
    node.size = static_cast<std::uint32_t>(nodes.size() - at);
    if (!(length_squared(node.axis) > 1e-6f)) return pi;
    node.axis = normalize(node.axis);
    float angle = 0;
    for (std::size_t i = 0; i < children.size(); ++i)
      if (nodes[children[i]].axis != Vec3(0))
        angle = std::max(angle, angles[i] + between(nodes[children[i]].axis, node.axis));
    return angle;
  }

  static void set_radius(Node& node, float angle) {
    const float safe = angle * 1.01f + 1e-5f;
    node.sin_radius = safe < 0.5f * pi ? std::sin(safe) : 2;
  }

  const Probe& probe_;
  int block_ = 1;  // texels along a leaf
};

}  // namespace

Irradiance::Irradiance(const Probe& probe) {
  const Tree tree(probe);
  const std::vector<Patch> roots = tree.roots();
  std::vector<std::vector<Node>> parts(roots.size());
  parallel_for(roots.size(), [&](std::size_t i) { tree.build(roots[i], parts[i]); });
  for (const std::vector<Node>& part : parts) nodes_.insert(nodes_.end(), part.begin(), part.end());
}

Rgb Irradiance::operator()(Vec3 normal) const {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    const float c = dot(normal, node.axis);
    const bool seen = c >= node.sin_radius, hidden = c <= -node.sin_radius;
    if (!seen && !hidden && node.size > 1) {
      ++i;
      continue;
    }
    // On the horizon a leaf's cosines are spread about evenly over c ± w, w that of a square with its corners on the
    // cone; the mean of max(0, cosine) is then (c + w)² / 4w.
    const float w = 0.7071f * node.sin_radius;
    for (std::size_t k = 0; k < 3 && c > -w; ++k)
      sum[k] += static_cast<double>(c >= w ? dot(normal, node.moment[k])
                                           : dot(node.axis, node.moment[k]) * sqr(c + w) / (4 * w));
    i += node.size;
  }
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

Probe diffuse_map(const Probe& probe, int rows, const FractionSink& progress) {
  const Irradiance irradiance(probe);
  const Vec2i size = chart_size(probe.projection, rows);
  Probe result{probe.projection, probe.texels, {}};
  for (std::size_t i = 0; i < probe.charts.size(); ++i) result.charts.emplace_back(size.x, size.y, rgb_channels());
  const auto rows_of_chart = static_cast<std::size_t>(size.y);
  parallel_for(result.charts.size() * rows_of_chart, progress, [&](std::size_t i) {
    const std::size_t chart = i / rows_of_chart;
    const int y = static_cast<int>(i % rows_of_chart);
    for (int x = 0; x < size.x; ++x)
      if (const auto d = direction(result.projection, {static_cast<int>(chart), uv_of(result, Vec2(x, y) + 0.5f)}))
        result.charts[chart].set_rgb(x, y, irradiance(*d) * inv_pi);
  });
  return result;
}

}  // namespace lambert::probe
