#include "lambert/polygon/decompose/interval_tree.h"

namespace lambert::polygon {
namespace {

std::uint32_t hashed(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

}  // namespace

void IntervalTree::insert(Place place, std::uint32_t item) { attach(place.item, place.side == Side::after, item); }

void IntervalTree::insert_after(std::uint32_t neighbour, std::uint32_t item) {
  std::uint32_t at = links_[neighbour].right;
  if (at == no_index) return attach(neighbour, true, item);
  while (links_[at].left != no_index) at = links_[at].left;
  attach(at, false, item);
}

void IntervalTree::attach(std::uint32_t parent, bool right, std::uint32_t item) {
  if (item >= links_.size()) links_.resize(item + 1);
  links_[item] = {no_index, no_index, parent, hashed(item)};
  if (parent == no_index) {
    root_ = item;
    return;
  }
  (right ? links_[parent].right : links_[parent].left) = item;
  while (links_[item].parent != no_index && links_[links_[item].parent].priority < links_[item].priority)
    rotate_up(item);
}

void IntervalTree::replace(std::uint32_t child, std::uint32_t by) {
  const std::uint32_t parent = links_[child].parent;
  if (by != no_index) links_[by].parent = parent;
  if (parent == no_index) {
    root_ = by;
  } else {
    (links_[parent].left == child ? links_[parent].left : links_[parent].right) = by;
  }
}

void IntervalTree::rotate_up(std::uint32_t child) {
  const std::uint32_t parent = links_[child].parent;
  const bool left = links_[parent].left == child;
  const std::uint32_t inner = left ? links_[child].right : links_[child].left;
  replace(parent, child);
  (left ? links_[parent].left : links_[parent].right) = inner;
  if (inner != no_index) links_[inner].parent = parent;
  (left ? links_[child].right : links_[child].left) = parent;
  links_[parent].parent = child;
}

void IntervalTree::remove(std::uint32_t item) {
  for (;;) {
    const std::uint32_t left = links_[item].left, right = links_[item].right;
    if (left == no_index || right == no_index) return replace(item, left == no_index ? right : left);
    rotate_up(links_[left].priority > links_[right].priority ? left : right);
  }
}

}  // namespace lambert::polygon
