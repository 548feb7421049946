#include "command.h"
#include "image/verb.h"
#include "verb_table.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

std::function<int()> add_image(CLI::App& app) {
  static constexpr Verb verbs[] = {
      {"convert", "Write in another format, depth or window, or some of the channels", add_image_convert},
      {"info", "What is in an image file", add_image_info},
  };
  const auto run = add_verbs(app, verbs);
  app.footer(
      "'lambert image VERB --help' explains a verb. Try:\n"
      "  lambert image info render.exr\n"
      "  lambert image convert render.exr -o render.png --exposure 1\n"
      "  lambert image convert render.exr -o albedo.tif --layer albedo --depth float");
  return run;
}

}  // namespace lambert::cli
