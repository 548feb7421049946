#include "print_path.h"

#include <fmt/format.h>

namespace lambert::cli {

void print_path(const std::filesystem::path& path) {
  fmt::print("{}\n", std::filesystem::absolute(path).lexically_normal().string());
}

}  // namespace lambert::cli
