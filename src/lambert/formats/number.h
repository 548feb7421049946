#pragma once
/// Numbers in text formats.

#include <cstdint>
#include <string>
#include <string_view>

namespace lambert {

/// Reads a decimal number at the start of [p, end), with an optional sign. Numbers too small for a float become 0.
/// Returns the place behind it, or null where no finite number stands (also for "inf", "nan" and "1e999").
const char* parse_float(const char* p, const char* end, float& value);
/// The same for integers; "1.5" is read up to the point. Null when out of the type's range.
const char* parse_int(const char* p, const char* end, std::int64_t& value);

/// A word of the input as messages show it: cut to a bearable length, unprintable bytes replaced by '?'.
std::string printable(std::string_view word);

}  // namespace lambert
