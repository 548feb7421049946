#include "hdr/verb.h"

#include "command.h"
#include "verb_table.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

std::function<int()> add_hdr(CLI::App& app) {
  static constexpr Verb verbs[] = {
      {"merge", "Photographs of different exposure to a radiance map", add_hdr_merge},
      {"response", "The camera's response, recovered from photographs", add_hdr_response},
      {"expose", "Photographs of a radiance map", add_hdr_expose},
      {"range", "The range of a radiance map", add_hdr_range},
  };
  const auto run = add_verbs(app, verbs);
  app.footer(
      "'lambert hdr VERB --help' explains a verb. Try:\n"
      "  lambert hdr merge IMG_*.jpg -o room.exr\n"
      "  lambert hdr merge a.png b.png c.png --times 1/60,1/15,1/4 -o room.exr --response response.csv\n"
      "  lambert hdr expose room.exr --bracket -4..4:2 -o shot_{}.png\n"
      "  lambert hdr range room.exr");
  return run;
}

}  // namespace lambert::cli
