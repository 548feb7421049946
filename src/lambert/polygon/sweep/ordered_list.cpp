#include "lambert/polygon/sweep/ordered_list.h"

namespace lambert::polygon {

OrderedList::Node OrderedList::new_node(std::uint32_t value) {
  // Marsaglia's xorshift.
  random_ ^= random_ << 13, random_ ^= random_ >> 17, random_ ^= random_ << 5;
  const Links links{.value = value, .priority = random_};
  if (free_.empty()) {
    nodes_.push_back(links);
    return static_cast<Node>(nodes_.size() - 1);
  }
  const Node n = free_.back();
  free_.pop_back();
  nodes_[n] = links;
  return n;
}

void OrderedList::replace_child(Node parent, Node child, Node by) {
  if (by != end) nodes_[by].parent = parent;
  if (parent == end) {
    root_ = by;
  } else {
    (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
  }
}

void OrderedList::rotate_up(Node n) {
  const Node parent = nodes_[n].parent;
  Links &child = nodes_[n], &above = nodes_[parent];
  replace_child(above.parent, parent, n);
  const bool was_left = above.left == n;
  Node& inner = was_left ? child.right : child.left;
  (was_left ? above.left : above.right) = inner;
  if (inner != end) nodes_[inner].parent = parent;
  inner = parent;
  above.parent = n;
}

OrderedList::Node OrderedList::insert_before(Node position, std::uint32_t value) {
  const Node n = new_node(value), before = nodes_[position].previous;
  nodes_[n].previous = before, nodes_[n].next = position;
  nodes_[before].next = n, nodes_[position].previous = n;
  if (root_ == end) {
    root_ = n;
    return n;
  }
  const bool as_left = position != end && nodes_[position].left == end;
  const Node parent = as_left ? position : before;
  (as_left ? nodes_[parent].left : nodes_[parent].right) = n;
  nodes_[n].parent = parent;
  while (nodes_[n].parent != end && nodes_[nodes_[n].parent].priority < nodes_[n].priority) rotate_up(n);
  return n;
}

void OrderedList::erase(Node n) {
  while (nodes_[n].left != end && nodes_[n].right != end) {
    const Node left = nodes_[n].left, right = nodes_[n].right;
    rotate_up(nodes_[left].priority > nodes_[right].priority ? left : right);
  }
  replace_child(nodes_[n].parent, n, nodes_[n].left != end ? nodes_[n].left : nodes_[n].right);
  nodes_[nodes_[n].previous].next = nodes_[n].next;
  nodes_[nodes_[n].next].previous = nodes_[n].previous;
  free_.push_back(n);
}

}  // namespace lambert::polygon
