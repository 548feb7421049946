#include "command.h"
#include "number_range.h"
#include "outputs.h"
#include "print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"
#include "lambert/draw/write_drawing.h"
#include "lambert/image/io.h"
#include "lambert/lab/demo.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace lambert::cli {
namespace {

struct Options {
  std::string name;
  std::vector<std::string> outputs;
  lab::LabSettings settings;
  bool json = false;
};

std::string list() {
  std::string text = "Demonstrations:\n";
  for (const lab::Demo& demo : lab::demos()) text += fmt::format("  {:<15} {}\n", demo.name, demo.summary);
  return text;
}

void check_outputs(const std::vector<std::string>& paths, const lab::Demo& demo) {
  for (const std::string& path : paths)
    if (!demo.has_drawing && format_extension(path) == ".svg")
      throw Error(output_name(path) + ": this picture is pixels: write .png, .exr or another image format");
  check_drawings(paths);
}

void write(const std::filesystem::path& path, const lab::Shown& shown) {
  if (const auto* drawing = std::get_if<draw::Drawing>(&shown.picture))
    draw::write_drawing(path, *drawing);
  else
    write_image(path, std::get<Image>(shown.picture));
}

int run(const Options& o) {
  if (o.name.empty()) {
    fmt::print("{}", list());
    return done;
  }
  const lab::Demo& demo = lab::demo(o.name);
  const std::vector<std::string> paths = o.outputs.empty() ? std::vector{o.name + ".png"} : o.outputs;
  check_outputs(paths, demo);
  const lab::Shown shown = demo.show(o.settings);
  for (const std::string& path : paths) write(path, shown);
  if (o.json) {
    nlohmann::ordered_json facts{{"demonstration", o.name}, {"written", paths}};
    for (const auto& [name, value] : shown.facts) facts["facts"][name] = value;
    fmt::print("{}\n", facts.dump(2));
  } else {
    for (const std::string& path : paths) print_path(path);
    for (const auto& [name, value] : shown.facts) fmt::print("  {:<52} {:.6g}\n", name, value);
  }
  return done;
}

}  // namespace

std::function<int()> add_lab(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("name", o->name, "Which one; without it they are listed")->type_name("NAME");
  add_outputs(app, o->outputs, "The picture, by extension; .svg for plots (NAME.png by default)");
  add_seed(app, o->settings.seed, "Of all random numbers");
  app.add_flag("--json", o->json, "Print the facts as JSON");
  app.footer(list() + "\n  lambert lab comb -o comb.png\n  lambert lab error -o error.svg");
  return [o] { return run(*o); };
}

}  // namespace lambert::cli
