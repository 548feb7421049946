#include "lambert/light/light_tree.h"

#include "lambert/light/light_split.h"

#include <algorithm>

namespace lambert {
namespace {

// A trail has 64 bits. From this depth on, halving keeps the tree of 2^20 lights and more within them.
constexpr std::uint32_t halving_depth = 32;

}  // namespace

LightTree::LightTree(std::span<const LightBounds> bounds, std::vector<std::uint32_t> lights)
    : trails_(bounds.size()), contains_(bounds.size()) {
  std::erase_if(lights, [&](std::uint32_t l) { return !(bounds[l].intensity > 0); });
  if (lights.empty()) return;
  nodes_.reserve(2 * lights.size() - 1);
  build(bounds, lights, 0, 0);
}

std::uint32_t LightTree::build(std::span<const LightBounds> bounds, std::span<std::uint32_t> lights,
                               std::uint64_t trail, std::uint32_t depth) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  if (lights.size() == 1) {
    nodes_[node] = {bounds[lights[0]], lights[0], true};
    trails_[lights[0]] = trail;
    contains_[lights[0]] = true;
    return node;
  }
  const std::size_t middle =
      depth < halving_depth ? split_by_orientation(bounds, lights) : split_in_halves(bounds, lights);
  const std::uint32_t first = build(bounds, lights.first(middle), trail, depth + 1);
  const std::uint32_t second = build(bounds, lights.subspan(middle), trail | (std::uint64_t{1} << depth), depth + 1);
  nodes_[node] = {merge(nodes_[first].bounds, nodes_[second].bounds), second, false};
  return node;
}

LightTree::Importances LightTree::child_importances(std::uint32_t node, Vec3 point, Vec3 normal) const {
  return {importance(nodes_[node + 1].bounds, point, normal),
          importance(nodes_[nodes_[node].index].bounds, point, normal)};
}

LightTree::Choice LightTree::choose(Vec3 point, Vec3 normal, float u) const {
  if (nodes_.empty()) return {};
  std::uint32_t node = 0;
  float probability = 1;
  while (!nodes_[node].leaf) {
    const auto [first, second] = child_importances(node, point, normal);
    const float sum = first + second;
    if (!(sum > 0)) return {};
    const float p_first = first / sum, p_second = second / sum;
    if (u < p_first) {
      u /= p_first, probability *= p_first, ++node;
    } else {
      if (second == 0) return {};
      u = (u - p_first) / p_second, probability *= p_second, node = nodes_[node].index;
    }
    u = std::min(u, one_minus_epsilon);
  }
  return {nodes_[node].index, probability};
}

float LightTree::probability(Vec3 point, Vec3 normal, std::uint32_t light) const {
  if (!contains_[light]) return 0;
  std::uint32_t node = 0;
  float probability = 1;
  for (std::uint64_t trail = trails_[light]; !nodes_[node].leaf; trail >>= 1) {
    const auto [first, second] = child_importances(node, point, normal);
    const float sum = first + second;
    if (!(sum > 0)) return 0;
    probability *= (trail & 1 ? second : first) / sum;
    node = trail & 1 ? nodes_[node].index : node + 1;
  }
  return probability;
}

}  // namespace lambert
