// One expression on images in memory, several times: CPU seconds (of all threads, user and system) and seconds by the
// clock, a line each time.
//   bench_composite TIMES EXPRESSION IMAGE…
#include "../process_time.h"
#include "lambert/image/composite/composite.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

int main(int argc, char** argv) {
  using namespace lambert;
  if (argc < 4) return 2;
  composite::Pictures pictures;
  for (int i = 3; i < argc; ++i) pictures.add(argv[i], read_image(argv[i]));
  const composite::Expression expression = composite::parse_expression(argv[2]);
  for (int times = std::atoi(argv[1]); times > 0; --times) {
    const double before = bench::cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    const Image result = composite::composite(expression, pictures);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    fmt::print("{:.4f} {:.4f}\n", bench::cpu_seconds() - before, elapsed.count());
  }
  return 0;
}
