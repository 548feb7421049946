#include "command.h"
#include "interrupt.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace {

using namespace lambert;

struct Entry {
  CLI::App* app;
  std::function<int()> run;
};

/// The first word that names no command where one must stand, with the known ones; empty when there is none.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  for (const std::string& word : words) {
    const std::vector<const CLI::App*> commands = at->get_subcommands([](const CLI::App*) { return true; });
    if (commands.empty() || word.starts_with('-')) break;
    const auto found = std::ranges::find_if(commands, [&](const CLI::App* c) { return c->get_name() == word; });
    if (found == commands.end()) {
      std::vector<std::string> names;
      for (const CLI::App* command : commands) names.push_back(command->get_name());
      return unknown_word(word, names);
    }
    at = *found;
  }
  return {};
}

/// The words of the command line, 'help COMMAND…' as 'COMMAND… --help'.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

/// The exit statuses of what fails. Those of 'compare' below 4 say how far two images lie apart.
struct Failures {
  int work = cli::failed, usage = cli::usage_error;
};
Failures failures_of(const std::vector<std::string>& words) {
  if (!words.empty() && words.front() == "compare") return {cli::not_compared, cli::not_compared};
  return {};
}

int run(std::vector<std::string> words, const Failures& failures) {
  CLI::App app("Lambert: one scene, every way of making an image of it.", "lambert");
  app.set_version_flag("--version", "lambert " LAMBERT_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return fmt::format("lambert: error: {} (--help lists the flags)\n", e.what());
  });
  app.set_help_flag("-h,--help", "Explain the command and exit");
  app.footer(
      "'lambert COMMAND --help' explains a command. Try:\n"
      "  lambert render                            the Cornell box, to out.png\n"
      "  lambert render kitchen.glb                kitchen.png beside it\n"
      "  lambert render box.pbrt -o box.exr --spp 256");

  std::vector<Entry> entries;
  const auto add = [&](const char* name, const char* summary, const cli::Command& command) {
    CLI::App* sub = app.add_subcommand(name, summary);
    entries.push_back({sub, command(*sub)});
  };
  add("render", "Make an image of a scene", cli::add_render);
  add("info", "Say what is in a scene or an image", cli::add_info);
  add("methods", "List the methods of rendering and their settings", cli::add_methods);
  add("image", "Convert, resample, filter and inspect image files", cli::add_image);
  add("polygon", "Algorithms of the plane on files of polygons", cli::add_polygon);
  add("lab", "Demonstrations of sampling, with pictures and plots", cli::add_lab);
  add("tonemap", "Map radiance to what a display can show", cli::add_tonemap);
  add("compare", "Say how far two images lie apart", cli::add_compare);
  add("hdr", "Radiance from photographs of different exposure, and back", cli::add_hdr);
  add("probe", "Environments: layouts, assembly, irradiance, lights", cli::add_probe);
  add("composite", "Put pictures together by an expression", cli::add_composite);
  add("denoise", "Remove the noise of a rendered image", cli::add_denoise);
  add("completion", "Print a completion script for a shell", cli::add_completion);

  if (words.empty()) {
    fmt::print(stderr, "{}", app.help());
    return cli::usage_error;
  }
  if (const std::string complaint = unknown_command(app, words); !complaint.empty()) {
    log::error("unknown command " + complaint);
    return cli::usage_error;
  }
  try {
    std::ranges::reverse(words);  // the last word first, as CLI11 wants a vector
    app.parse(std::move(words));
    for (const Entry& e : entries)
      if (e.app->parsed()) return e.run();
  } catch (const CLI::ValidationError& e) {
    app.exit(e);
    return failures.work;  // as other values that a flag does not have
  } catch (const CLI::ParseError& e) {
    const int status = app.exit(e);
    return status == 0 ? cli::done : failures.usage;
  }
  return failures.usage;
}

/// Throws Error when what was printed did not come to its place, such as a full disk.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw Error(std::string("standard output: cannot write: ") + std::strerror(errno));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words = words_of(argc, argv);
  const Failures failures = failures_of(words);
  cli::end_on_interrupt();
  try {
    const int status = run(words, failures);
    flush_output();
    return status;
  } catch (const Error& e) {
    log::error(e.what());
  } catch (const std::system_error& e) {
    log::error(fmt::format("{}: {}", std::ferror(stdout) ? "standard output" : "unexpected", e.what()));
  } catch (const std::bad_alloc&) {
    log::error("out of memory");
  } catch (const std::exception& e) {
    log::error(fmt::format("unexpected: {}", e.what()));
  }
  return failures.work;
}
