#pragma once
/// JSON as a stream of values that know their place in the text: what readers of JSON formats are built on.

#include "lambert/base/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace lambert {

/// Bytes [begin, end) of a text.
struct TextRange {
  std::size_t begin = 0, end = 0;
  std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Line and column, both from 1, of a byte of `text`; columns count bytes. Behind the end is the place after the last
/// byte.
SourceLocation location_in(std::string_view text, const std::string& name, std::size_t offset);

/// Called in the order of the text. `at` is the value's own text: `"a"` with its quotes, one bracket of an array.
class JsonEvents {
 public:
  virtual ~JsonEvents() = default;
  virtual void null(TextRange at) = 0;
  virtual void boolean(bool value, TextRange at) = 0;
  /// Always finite; integers beyond 2^53 are rounded.
  virtual void number(double value, TextRange at) = 0;
  virtual void string(std::string value, TextRange at) = 0;
  virtual void begin_array(TextRange at) = 0;
  virtual void end_array(TextRange at) = 0;
  virtual void begin_object(TextRange at) = 0;
  virtual void key(std::string name, TextRange at) = 0;
  virtual void end_object(TextRange at) = 0;
};

inline constexpr std::size_t max_json_depth = 256;

/// Throws Error with `name`, line and column when the text is not JSON (RFC 8259), a number is too large for a double
/// or brackets nest deeper than max_json_depth. Linear time; no memory but for the events' strings.
void parse_json_events(std::string_view text, const std::string& name, JsonEvents& events);

}  // namespace lambert
