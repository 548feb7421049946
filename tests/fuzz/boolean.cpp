#include "stress/boolean_case.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

/// Whatever the operands are, the results are valid and agree with each other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lambert::polygon;
  const BooleanCase input = decode_case(std::span(data, size));
  const std::string fault = find_fault(input);
  if (!fault.empty()) {
    std::fprintf(stderr, "%s\n%s", fault.c_str(), to_code(input).c_str());
    std::abort();
  }
  return 0;
}
