#pragma once
#include "lambert/base/vec.h"
#include "lambert/formats/gltf/buffers.h"
#include "lambert/formats/gltf/elements.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lambert::gltf {

/// An accessor, whose elements are read as floats or integers: sparse ones, any stride and all types; "min" and "max"
/// are not looked at. Throws Error at the place that is wrong.
class Accessor {
 public:
  /// `reference` is a member that holds the accessor's index.
  Accessor(const JsonView& root, const JsonView& reference, Buffers& buffers, Budget& budget);

  std::size_t count() const { return dense_.count; }
  std::size_t components() const { return dense_.components; }
  ComponentType type() const { return dense_.type; }
  bool normalized() const { return dense_.normalized; }
  [[noreturn]] void fail(const std::string& why) const { json_.fail(why); }

  /// components() floats per element; normalized integers become [0,1] or [-1,1]. A number that is not finite is an
  /// Error that names its element.
  std::vector<float> floats(const Selection& selection = {}) const;
  /// Of scalars of an unsigned type.
  std::vector<std::uint32_t> integers() const;
  /// Throws Error unless components() is that of the vector.
  template <class Vec>
  std::vector<Vec> vectors(const Selection& selection = {}) const;

 private:
  struct Sparse {
    Elements indices, values;
  };
  void read_sparse_part(Buffers& buffers);
  void replace(const Selection& selection, std::span<float> out) const;
  void expect_components(std::size_t n) const;

  JsonView json_;
  Budget* budget_;
  Elements dense_;
  std::optional<Sparse> sparse_;
};

/// Floats grouped into vectors; `floats` has a multiple of Vec::length() of them.
template <class Vec>
std::vector<Vec> grouped(std::span<const float> floats) {
  constexpr std::size_t n = static_cast<std::size_t>(Vec::length());
  std::vector<Vec> vectors(floats.size() / n);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t c = 0; c < n; ++c) vectors[i][static_cast<int>(c)] = floats[n * i + c];
  return vectors;
}

template <class Vec>
std::vector<Vec> Accessor::vectors(const Selection& selection) const {
  expect_components(static_cast<std::size_t>(Vec::length()));
  return grouped<Vec>(floats(selection));
}

}  // namespace lambert::gltf
