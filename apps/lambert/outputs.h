#pragma once
/// The files that commands write. "-" is standard output, "png:-" says a format with it; what a command prints beside
/// that goes to standard error.

#include "cli_fwd.h"

#include "lambert/base/progress.h"
#include "lambert/image/io.h"

#include <string>
#include <vector>

namespace lambert::cli {

/// A flag that names one file.
CLI::Option* add_output(CLI::App& app, const std::string& flags, std::string& file, const std::string& help);
/// -o,--output, which may be given several times.
CLI::Option* add_outputs(CLI::App& app, std::vector<std::string>& files, const std::string& help);

/// Throws Error, before any work is done, when an image could not be written to one of them.
void check_images(const std::vector<std::string>& files, const WriteOptions& options = {});
/// The same for a drawing, which may be .svg too.
void check_drawings(const std::vector<std::string>& files);
/// The same for text, whatever the name; an empty name is no output.
void check_texts(const std::vector<std::string>& files);
/// The same image to each, by its extension; prints the paths.
void write_images(const std::vector<std::string>& files, const Image& image, const WriteOptions& options = {},
                  const FractionSink& progress = {});

}  // namespace lambert::cli
