#include "lambert/base/error.h"
#include "lambert/image/composite/expression.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Whatever the bytes are, both readers return or throw Error, and what one has read reads back from its text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert;
  using namespace lambert::composite;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const auto parse : {+[](std::string_view t) { return parse_expression(t, "fuzz"); },
                           +[](std::string_view t) { return parse_json_expression(t, "fuzz"); }}) {
    Expression tree;
    try {
      tree = parse(text);
    } catch (const Error&) {
      continue;
    }
    if (parse_expression(to_text(tree), "written") != tree) std::abort();
  }
  return 0;
}
