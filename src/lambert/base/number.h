#pragma once
/// Numbers in text formats.

#include <cstdint>
#include <string>
#include <string_view>

namespace lambert {

/// Reads a decimal number at the start of [p, end), with an optional sign, to the nearest float or double. Numbers too
/// small for the type become 0. Returns the place behind it, or null where no finite number stands (also for "inf",
/// "nan" and "1e999").
const char* parse_float(const char* p, const char* end, float& value);
const char* parse_double(const char* p, const char* end, double& value);
/// The same for integers; "1.5" is read up to the point. Null when out of the type's range.
const char* parse_int(const char* p, const char* end, std::int64_t& value);

/// Appends the shortest decimal that reads back as the same number of its type: "0.1", "1e+300", "-0".
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
std::string number_text(double value);

/// A word of the input as messages show it: cut to a bearable length, control characters and bytes that
/// are no UTF-8 replaced by '?'.
std::string printable(std::string_view word);

}  // namespace lambert
