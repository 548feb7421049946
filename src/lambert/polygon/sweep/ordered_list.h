#pragma once
#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// A list of numbers whose order is set by where they are inserted, searched by bisection: a treap (Seidel and Aragon
/// 1996) threaded by a doubly linked list. Nodes keep their index until erased. Steps to neighbours O(1), the rest
/// O(log n) expected.
class OrderedList {
 public:
  using Node = std::uint32_t;
  static constexpr Node end = 0;  ///< stands after the last node and before the first

  Node next(Node n) const { return nodes_[n].next; }
  Node previous(Node n) const { return nodes_[n].previous; }
  std::uint32_t operator[](Node n) const { return nodes_[n].value; }
  void set(Node n, std::uint32_t value) { nodes_[n].value = value; }

  Node insert_before(Node position, std::uint32_t value);
  void erase(Node n);

  /// The first node whose value does not satisfy `before`, which must hold for a first part of the list and for none
  /// of the rest; `end` when all do.
  template <class Predicate>
  Node partition_point(Predicate before) const {
    Node found = end;
    for (Node n = root_; n != end;) {
      if (before(nodes_[n].value)) {
        n = nodes_[n].right;
      } else {
        found = n, n = nodes_[n].left;
      }
    }
    return found;
  }

 private:
  struct Links {
    std::uint32_t value = 0, priority = 0;
    Node left = end, right = end, parent = end, previous = end, next = end;
  };
  Node new_node(std::uint32_t value);
  void replace_child(Node parent, Node child, Node by);
  void rotate_up(Node n);

  std::vector<Links> nodes_{Links{}};
  std::vector<Node> free_;
  Node root_ = end;
  std::uint32_t random_ = 2463534242;
};

}  // namespace lambert::polygon
