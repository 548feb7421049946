#pragma once
#include "lambert/base/rgb.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lambert {

/// The bodies that a path is inside of, the one entered last on top: rays are absorbed as that one says. Of more than
/// eight bodies inside each other the outermost are forgotten.
class Bodies {
 public:
  bool empty() const { return count_ == 0; }
  /// σ of the body on top [1 / scene unit]; 0 outside of all.
  Rgb absorption() const { return count_ ? bodies_[count_ - 1].absorption : Rgb(0.0f); }

  void enter(std::uint32_t surface, Rgb absorption) {
    if (count_ == bodies_.size()) {
      for (std::size_t i = 1; i < count_; ++i) bodies_[i - 1] = bodies_[i];
      --count_;
    }
    bodies_[count_++] = {surface, absorption};
  }
  /// Takes the uppermost entry of `surface` away, if there is one.
  void leave(std::uint32_t surface) {
    for (std::size_t i = count_; i-- > 0;) {
      if (bodies_[i].surface != surface) continue;
      for (--count_; i < count_; ++i) bodies_[i] = bodies_[i + 1];
      return;
    }
  }

 private:
  struct Body {
    std::uint32_t surface;
    Rgb absorption;
  };
  std::array<Body, 8> bodies_;
  std::size_t count_ = 0;
};

}  // namespace lambert
