// CPU seconds, in place (of all threads, user and system) of one operator on a radiance map in memory:
//   bench_tonemap MAP OPERATOR [key=value…]
#include "lambert/image/io.h"
#include "lambert/image/tonemap/tonemap.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>
#include <string>
#include <utility>

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
  if (argc < 3) return 2;
  Image map = read_image(argv[1]);
  ToneSettings settings{.op = tone_operator(argv[2])};
  SettingTable table = tone_operator_settings(settings.op);
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    table.set(word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
  }
  const double before = cpu_seconds();
  const Image shown = tonemap(std::move(map), settings);
  fmt::print("{:.6f}\n", cpu_seconds() - before);
  return shown.empty();
}
