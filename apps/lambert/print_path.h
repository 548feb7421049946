#pragma once
#include <filesystem>

namespace lambert::cli {

/// Prints, absolute, the path of a file that was written: what scripts read.
void print_path(const std::filesystem::path& path);

}  // namespace lambert::cli
