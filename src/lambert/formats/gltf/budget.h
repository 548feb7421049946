#pragma once
#include "lambert/formats/gltf/json.h"

#include <cstddef>

namespace lambert::gltf {

/// What reading may cost: a small file that asks for much (lying counts, the same data again and again) is refused
/// before it eats memory and time. Everything that is decoded is charged once per use.
class Budget {
 public:
  /// Each byte of input pays for 64 bytes of scene: the most that any of the compressed forms can mean.
  void earn(std::size_t input_bytes) { left_ += 64 * input_bytes; }

  /// Throws Error at `place` when `count` items of `bytes_each` are more than what is left.
  void charge(std::size_t count, std::size_t bytes_each, const JsonView& place) {
    if (count > left_ / bytes_each)
      place.fail("asks for " + std::to_string(count) + " items, which is out of proportion to the size of the file");
    left_ -= count * bytes_each;
  }

 private:
  std::size_t left_ = std::size_t{1} << 30;
};

}  // namespace lambert::gltf
