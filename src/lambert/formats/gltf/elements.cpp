#include "lambert/formats/gltf/elements.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lambert::gltf {
namespace {

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// Calls f with a value of the C++ type that stands for `type`.
template <class F>
void with_type(ComponentType type, F&& f) {
  switch (type.code) {
    case 5120: return f(std::int8_t{});
    case 5121: return f(std::uint8_t{});
    case 5122: return f(std::int16_t{});
    case 5123: return f(std::uint16_t{});
    case 5125: return f(std::uint32_t{});
    default: return f(float{});
  }
}

}  // namespace

ComponentType component_type(const JsonView& place) {
  const std::size_t code = place.count();
  if (code == 5120 || code == 5121) return {code, 1};
  if (code == 5122 || code == 5123) return {code, 2};
  if (code == 5125 || code == 5126) return {code, 4};
  place.fail("unknown component type " + std::to_string(code) + " (known: 5120, 5121, 5122, 5123, 5125, 5126)");
}

float normalization(ComponentType type) {
  float factor = 1;
  with_type(type, [&]<class T>(T) {
    if constexpr (std::is_integral_v<T>) factor = 1 / static_cast<float>(std::numeric_limits<T>::max());
  });
  return factor;
}

void Elements::lay_over(std::span<const std::byte> all, std::size_t offset, const JsonView& place) {
  if (stride == 0) stride = element_size();
  if (count == 0) return;
  const std::size_t size = all.size(), element = element_size();
  if (offset > size || element > size - offset || count - 1 > (size - offset - element) / stride)
    place.fail(std::to_string(count) + " elements from byte " + std::to_string(offset) + " do not fit into the " +
               std::to_string(size) + " bytes of the buffer view");
  bytes = all.subspan(offset);
}

void Elements::read(const Selection& selection, std::span<float> out) const {
  if (bytes.empty()) return;
  with_type(type, [&]<class T>(T) {
    const float scale = normalized ? normalization(type) : 1;
    // A signed integer reaches one further below zero than above.
    const float least = normalized ? -1.0f : std::numeric_limits<float>::lowest();
    float* to = out.data();
    for (std::size_t i = 0, n = out.size() / components; i < n; ++i) {
      const std::byte* from = bytes.data() + stride * (selection.empty() ? i : selection[i]);
      for (std::size_t c = 0; c < components; ++c) {
        const float value = scale * static_cast<float>(load<T>(from + c * sizeof(T)));
        *to++ = std::is_integral_v<T> ? std::max(value, least) : value;
      }
    }
  });
}

std::vector<std::uint32_t> Elements::integers() const {
  std::vector<std::uint32_t> out(count);
  if (bytes.empty()) return out;
  with_type(type, [&]<class T>(T) {
    if constexpr (std::is_unsigned_v<T>)
      for (std::size_t i = 0; i < count; ++i) out[i] = load<T>(bytes.data() + stride * i);
  });
  return out;
}

}  // namespace lambert::gltf
