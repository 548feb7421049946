#pragma once
/// The verbs of `lambert image`.

#include "../cli_fwd.h"

#include <filesystem>
#include <functional>

namespace lambert::cli {

std::function<int()> add_image_convert(CLI::App& app);
std::function<int()> add_image_info(CLI::App& app);
std::function<int()> add_resize(CLI::App& app);
std::function<int()> add_blur(CLI::App& app);
std::function<int()> add_resolve(CLI::App& app);
std::function<int()> add_mipmap(CLI::App& app);
std::function<int()> add_fill_gaps(CLI::App& app);
std::function<int()> add_plane(CLI::App& app);

/// Prints what is in an image file. Throws Error when it cannot be read.
void print_image_info(const std::filesystem::path& file, bool json);

}  // namespace lambert::cli
