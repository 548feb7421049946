#pragma once
/// JSON as values that know their place in the text.

#include "lambert/base/json_events.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lambert::composite {

enum class JsonKind { null, boolean, number, string, array, object };

struct JsonValue {
  JsonKind kind = JsonKind::null;
  double number = 0;
  std::string string;
  std::vector<JsonValue> values;                        ///< of an array or an object
  std::vector<std::pair<std::string, TextRange>> keys;  ///< of an object, one for each value
  TextRange at;
};

/// Throws Error as parse_json_events does.
JsonValue parse_json_tree(std::string_view text, const std::string& name);

}  // namespace lambert::composite
