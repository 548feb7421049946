// CPU seconds, in place (of all threads, user and system) of one operator on a radiance map in memory:
//   bench_tonemap MAP OPERATOR [key=value…]
#include "../process_time.h"
#include "lambert/image/io.h"
#include "lambert/image/tonemap/tonemap.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

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
  const double before = bench::cpu_seconds();
  const Image shown = tonemap(std::move(map), settings);
  fmt::print("{:.6f}\n", bench::cpu_seconds() - before);
  return shown.empty();
}
