#include "command.h"
#include "image/verb.h"
#include "verb_table.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

std::function<int()> add_image(CLI::App& app) {
  static constexpr Verb verbs[] = {
      {"convert", "Write in another format, depth or window, or some of the channels", add_image_convert},
      {"info", "What is in an image file", add_image_info},
      {"resize", "Resample to another size", add_resize},
      {"blur", "Blur by a Gaussian, a box or a triangle", add_blur},
      {"resolve", "Average the samples of a supersampled image", add_resolve},
      {"mipmap", "The levels of a mip map, or all packed in one square", add_mipmap},
      {"fill-gaps", "Fill the gaps of a texture atlas from its charts", add_fill_gaps},
      {"plane", "Show lookups of a texture on a plane that recedes to the horizon", add_plane},
  };
  const auto run = add_verbs(app, verbs);
  app.footer(
      "'lambert image VERB --help' explains a verb. Try:\n"
      "  lambert image info render.exr\n"
      "  lambert image convert render.exr -o render.png --exposure 1\n"
      "  lambert image convert render.exr -o albedo.tif --layer albedo --depth float\n"
      "  lambert image resize photo.jpg -o small.png --size 640x\n"
      "  lambert image mipmap texture.png -o packed.png --packed");
  return run;
}

}  // namespace lambert::cli
