#pragma once
/// The verbs of `lambert image`.

#include <CLI/App.hpp>

#include <functional>

namespace lambert::cli {

std::function<int()> add_resize(CLI::App& app);
std::function<int()> add_blur(CLI::App& app);
std::function<int()> add_resolve(CLI::App& app);
std::function<int()> add_mipmap(CLI::App& app);
std::function<int()> add_fill_gaps(CLI::App& app);
std::function<int()> add_plane(CLI::App& app);

}  // namespace lambert::cli
