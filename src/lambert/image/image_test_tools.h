#pragma once
/// What tests of image files share.

#include "lambert/base/hash.h"
#include "lambert/image/formats/codecs.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// Hashed values in [0, top), the same ones every time.
inline Image noise(int width, int height, std::vector<std::string> channels, float top = 1) {
  Image image(width, height, std::move(channels));
  std::uint64_t i = 0;
  for (float& v : image.pixels()) v = top * hash_to_float(hash_values(++i));
  return image;
}

inline std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline Bytes bytes_of(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

template <class T>
void append(std::string& to, T value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Equal, or both not a number.
inline bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace lambert
