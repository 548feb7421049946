#include "print_path.h"

#include "progress_report.h"

#include "lambert/base/standard_streams.h"

#include <fmt/format.h>

namespace lambert::cli {

void print_path(const std::filesystem::path& path) {
  if (is_standard_stream(path)) return;
  end_bar_line();
  fmt::print("{}\n", std::filesystem::absolute(path).lexically_normal().string());
}

}  // namespace lambert::cli
