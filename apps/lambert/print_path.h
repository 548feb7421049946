#pragma once
#include <filesystem>

namespace lambert::cli {

/// Prints, absolute, the path of a file that was written: what scripts read. Standard output has none.
void print_path(const std::filesystem::path& path);

}  // namespace lambert::cli
