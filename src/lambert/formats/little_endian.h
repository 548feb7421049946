#pragma once
#include <bit>
#include <cstring>
#include <string>

namespace lambert {

static_assert(std::endian::native == std::endian::little, "binary files are written as memory holds them");

/// Appends the bytes of a number, or of a vector of numbers, in little-endian order.
template <class T>
void append_bytes(std::string& out, const T& value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

}  // namespace lambert
