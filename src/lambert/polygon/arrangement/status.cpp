#include "lambert/polygon/arrangement/status.h"

namespace lambert::polygon::arrangement {

void Status::replace_child(Place parent, Place old_child, Place child) {
  if (parent == none) {
    root_ = child;
  } else {
    (nodes_[parent].left == old_child ? nodes_[parent].left : nodes_[parent].right) = child;
  }
  if (child != none) nodes_[child].parent = parent;
}

void Status::rotate_up(Place place) {
  const Place parent = nodes_[place].parent, grand = nodes_[parent].parent;
  const bool is_left = nodes_[parent].left == place;
  const Place moved = is_left ? nodes_[place].right : nodes_[place].left;
  replace_child(grand, parent, place);
  (is_left ? nodes_[parent].left : nodes_[parent].right) = moved;
  if (moved != none) nodes_[moved].parent = parent;
  (is_left ? nodes_[place].right : nodes_[place].left) = parent;
  nodes_[parent].parent = place;
}

Status::Place Status::insert_above(Place place, std::uint32_t item) {
  state_ ^= state_ << 13;  // xorshift64 (Marsaglia 2003)
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  Place made = static_cast<Place>(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    made = free_.back();
    free_.pop_back();
  }
  const Place next = place == none ? lowest_ : nodes_[place].above;
  nodes_[made] = {item, static_cast<std::uint32_t>(state_ >> 32), none, none, none, place, next};
  (place == none ? lowest_ : nodes_[place].above) = made;
  if (next != none) nodes_[next].below = made;

  // Right of `place` when nothing hangs there; else the next one up has no left child.
  if (place != none && nodes_[place].right == none) {
    nodes_[place].right = made;
    nodes_[made].parent = place;
  } else if (next != none) {
    nodes_[next].left = made;
    nodes_[made].parent = next;
  } else {
    root_ = made;
  }
  while (nodes_[made].parent != none && nodes_[nodes_[made].parent].priority < nodes_[made].priority) rotate_up(made);
  return made;
}

void Status::erase(Place place) {
  while (nodes_[place].left != none && nodes_[place].right != none) {
    const Place left = nodes_[place].left, right = nodes_[place].right;
    rotate_up(nodes_[left].priority > nodes_[right].priority ? left : right);
  }
  const Node node = nodes_[place];
  replace_child(node.parent, place, node.left != none ? node.left : node.right);
  (node.below == none ? lowest_ : nodes_[node.below].above) = node.above;
  if (node.above != none) nodes_[node.above].below = node.below;
  free_.push_back(place);
}

}  // namespace lambert::polygon::arrangement
