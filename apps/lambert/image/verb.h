#pragma once
#include <CLI/App.hpp>

#include <filesystem>
#include <functional>

namespace lambert::cli {

std::function<int()> add_image_convert(CLI::App& app);
std::function<int()> add_image_info(CLI::App& app);

/// Prints what is in an image file. Throws Error when it cannot be read.
void print_image_info(const std::filesystem::path& file, bool json);

}  // namespace lambert::cli
