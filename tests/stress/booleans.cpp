/// usage: stress_booleans COUNT [SEED]: runs the booleans on COUNT random degenerate inputs, one process a core. Stops
/// at the first fault and prints the input.

#include "stress/boolean_case.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

int main(int count, char** arguments) {
  using namespace lambert::polygon;
  const std::uint64_t cases = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 100'000;
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  std::mt19937_64 random(seed);
  std::array<std::uint64_t, 40> words;
  const auto processor_time = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  double slowest = 0;
  std::uint64_t slowest_case = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    for (std::uint64_t& word : words) word = random();
    const BooleanCase input = decode_case({reinterpret_cast<const std::uint8_t*>(words.data()), sizeof words});
    const double before = processor_time();
    if (const std::string fault = find_fault(input); !fault.empty()) {
      std::printf("case %llu of seed %llu: %s\n%s", static_cast<unsigned long long>(i),
                  static_cast<unsigned long long>(seed), fault.c_str(), to_code(input).c_str());
      return 1;
    }
    if (const double time = processor_time() - before; time > slowest) {
      slowest = time;
      slowest_case = i;
    }
  }
  std::printf("%llu cases of seed %llu without fault in %.0f s of processor time; the slowest, %llu, took %.2g s\n",
              static_cast<unsigned long long>(cases), static_cast<unsigned long long>(seed), processor_time(),
              static_cast<unsigned long long>(slowest_case), slowest);
  return 0;
}
