#include "outputs.h"
#include "print_path.h"

#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {
namespace {

/// Nothing else may be printed where the file goes, so this is settled while flags are read.
CLI::Option* named_as_output(CLI::Option* option) {
  return option->type_name("FILE")->check([](const std::string& file) {
    if (is_standard_stream(file)) reserve_standard_output();
    return std::string();
  });
}

}  // namespace

CLI::Option* add_output(CLI::App& app, const std::string& flags, std::string& file, const std::string& help) {
  return named_as_output(app.add_option(flags, file, help));
}

CLI::Option* add_outputs(CLI::App& app, std::vector<std::string>& files, const std::string& help) {
  return named_as_output(app.add_option("-o,--output", files, help + "; several allowed")->allow_extra_args(false));
}

void check_images(const std::vector<std::string>& files, const WriteOptions& options) {
  for (const std::string& file : files) {
    check_write_options(file, options);
    check_writable(file);
  }
}

void check_drawings(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (format_extension(file) == ".svg")
      check_writable(file);
    else
      check_images({file});
}

void check_texts(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (!file.empty()) check_writable(file);
}

void write_images(const std::vector<std::string>& files, const Image& image, const WriteOptions& options,
                  const FractionSink& progress) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    write_image(files[i], image, options);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    print_path(files[i]);
  }
}

}  // namespace lambert::cli
