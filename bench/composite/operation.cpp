// One expression on images in memory, several times: CPU seconds (of all threads, user and system) and seconds by the
// clock, a line each time.
//   bench_composite TIMES EXPRESSION IMAGE…
#include "lambert/image/composite/composite.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace lambert;
  if (argc < 4) return 2;
  composite::Pictures pictures;
  for (int i = 3; i < argc; ++i) pictures.add(argv[i], read_image(argv[i]));
  const composite::Expression expression = composite::parse_expression(argv[2]);
  for (int times = std::atoi(argv[1]); times > 0; --times) {
    const double before = cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    const Image result = composite::composite(expression, pictures);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    fmt::print("{:.4f} {:.4f}\n", cpu_seconds() - before, elapsed.count());
  }
  return 0;
}
