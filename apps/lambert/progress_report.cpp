#include "progress_report.h"

#include "lambert/base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>

namespace lambert::cli {
namespace {

std::atomic<bool> bar_is_open{false};  // its line has no end yet

void draw_bar(const Progress& p) {
  constexpr int width = 28;
  const int filled = static_cast<int>(p.fraction * width);
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  const std::string rates = p.samples > 0 ? fmt::format("{}samples/s  {}rays/s  ", with_unit(p.samples_per_second),
                                                        with_unit(p.rays_per_second))
                                          : "";
  fmt::print(stderr, "\r[{}] {:3.0f} %  {}{} left\x1b[K", bar, 100 * p.fraction, rates, duration(p.remaining_seconds));
  bar_is_open = true;
  if (p.fraction >= 1) end_bar_line();
  std::fflush(stderr);
}

struct Bar {
  ~Bar() { end_bar_line(); }
  void draw(const Progress& p) const { draw_bar(p); }
};

ProgressSink bar() {
  return [line = std::make_shared<Bar>()](const Progress& p) { line->draw(p); };
}

void print_json_line(const Progress& p) {
  const nlohmann::ordered_json line{{"fraction", p.fraction},
                                    {"elapsed_seconds", p.elapsed_seconds},
                                    {"remaining_seconds", p.remaining_seconds},
                                    {"samples", p.samples},
                                    {"samples_per_second", p.samples_per_second},
                                    {"rays", p.rays},
                                    {"rays_per_second", p.rays_per_second}};
  fmt::print(stderr, "{}\n", line.dump());
  std::fflush(stderr);
}

}  // namespace

void end_bar_line() {
  if (bar_is_open.exchange(false)) fmt::print(stderr, "\n");
}

std::string with_unit(double value) {
  if (value >= 1e9) return fmt::format("{:.2f} G", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.2f} M", value / 1e6);
  if (value >= 1e3) return fmt::format("{:.2f} k", value / 1e3);
  return fmt::format("{:.0f} ", value);
}

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
  if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
  if (whole >= 60) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

std::vector<std::string> progress_styles() { return {"tty", "ndjson", "none"}; }

ProgressSink progress_sink(const std::string& style) {
  if (style.empty()) return ::isatty(STDERR_FILENO) ? bar() : ProgressSink();
  if (style == "tty") return bar();
  if (style == "ndjson") return print_json_line;
  if (style == "none") return {};
  throw Error("--progress: unknown style " + unknown_word(style, progress_styles()));
}

}  // namespace lambert::cli
