#include "probe/verb.h"

#include "command.h"
#include "verb_table.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

std::function<int()> add_probe(CLI::App& app) {
  static constexpr Verb verbs[] = {
      {"convert", "Write an environment in another layout or size", add_probe_convert},
      {"rotate", "Turn an environment", add_probe_rotate},
      {"assemble", "One environment from photographs of a mirror ball", add_probe_assemble},
      {"irradiance", "The light that arrives at surfaces of every direction", add_probe_irradiance},
      {"sh", "Spherical harmonics of an environment", add_probe_sh},
      {"lights", "Suns apart from the sky, or median-cut lights", add_probe_lights},
      {"find-ball", "Find and crop a ball in a photograph", add_probe_find_ball},
      {"check", "Does a sky probe hold the whole range of its light?", add_probe_check},
  };
  const auto run = add_verbs(app, verbs);
  app.footer(
      "'lambert probe VERB --help' explains a verb. Layouts and their axes are in docs/guide/probe.md. Try:\n"
      "  lambert probe convert room.hdr --to vertical-cross -o cross.exr\n"
      "  lambert probe convert ball.exr --from mirror-ball --to lat-long -o room.exr\n"
      "  lambert probe lights sky.exr --sky sky-without-sun.exr");
  return run;
}

}  // namespace lambert::cli
