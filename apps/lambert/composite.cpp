#include "command.h"
#include "number_range.h"
#include "outputs.h"
#include "print_path.h"
#include "work.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/parallel.h"
#include "lambert/image/composite/composite.h"
#include "lambert/image/composite/sequence.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lambert::cli {
namespace {

using namespace composite;

struct Options {
  std::string expression, frames, resolution, depth = "auto", compression = "zip", print, stats;
  std::vector<std::string> outputs;
  std::size_t threads = 0;
  WorkOptions work;
};

struct Source {
  std::string text, name;
  Expression tree;
};

bool has_extension(const std::string& path, const char* extension) {
  return std::filesystem::path(path).extension() == extension;
}

/// The tree of a JSON file, of a file of text, or of the words themselves.
Source read_expression(const std::string& words) {
  const bool json = has_extension(words, ".json");
  if (!json && !has_extension(words, ".comp")) return {words, "expression", parse_expression(words)};
  std::string text(MappedFile(words).text());
  Expression tree = json ? parse_json_expression(text, words) : parse_expression(text, words);
  return {std::move(text), words, std::move(tree)};
}

std::optional<Window> display_of(const Options& o) {
  if (o.resolution.empty()) return std::nullopt;
  int width = 0, height = 0, used = 0;
  const bool read = std::sscanf(o.resolution.c_str(), "%5dx%5d%n", &width, &height, &used) == 2 &&
                    static_cast<std::size_t>(used) == o.resolution.size();
  if (!read || width < 1 || height < 1 || width > 16384 || height > 16384)
    throw Error("--resolution: expected WIDTHxHEIGHT from 1 to 16384, got '" + o.resolution + "'");
  return Window{0, 0, width, height};
}

void check_outputs(const Options& o, const WriteOptions& write, std::size_t frames) {
  for (const std::string& path : o.outputs) {
    if (frames > 1 && !has_frame_pattern(path))
      throw Error(path + ": several frames need a name with #### or %04d in it");
    check_images({name_at_frame(path, 1)}, write);
  }
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int run(const Options& o) {
  const Source source = read_expression(o.expression);
  if (o.print == "text") fmt::print("{}\n", to_text(source.tree));
  if (o.print == "json") fmt::print("{}", to_json(source.tree));
  if (!o.print.empty()) return done;
  if (o.outputs.empty()) throw CLI::RequiredError("--output");
  const std::vector<int> frames = o.frames.empty() ? std::vector{1} : parse_frames(o.frames);
  if (o.frames.empty())
    for (const std::string& file : files_of(source.tree))
      if (has_frame_pattern(file)) throw Error(file + ": say which frames: --frames FIRST-LAST");
  const WriteOptions write{.depth = parse_depth(o.depth), .compression = parse_compression(o.compression)};
  check_outputs(o, write, frames.size());
  check_files(source.tree, frames);
  if (o.threads > 0) set_thread_count(o.threads);
  CompositeSettings settings{.display = display_of(o), .name = source.name, .text = source.text};
  const FractionSink progress = start_work(o.work);
  const auto start = std::chrono::steady_clock::now();
  std::size_t bytes = 0;
  double frames_done = 0;
  int bands = 0;
  for (const int frame : frames) {
    std::vector<std::filesystem::path> outputs;
    for (const std::string& path : o.outputs) outputs.emplace_back(name_at_frame(path, frame));
    settings.frame = frame;
    settings.progress = part_of(progress, frames_done / static_cast<double>(frames.size()),
                                (frames_done + 1) / static_cast<double>(frames.size()));
    const CompositeReport report = composite_to_files(source.tree, outputs, write, settings);
    ++frames_done;
    bytes = std::max(bytes, report.bytes_in_bands);
    bands += report.bands;
    for (const auto& path : outputs) print_path(path);
  }
  if (!o.stats.empty()) {
    const nlohmann::ordered_json facts{
        {"frames", frames.size()}, {"seconds", seconds_since(start)}, {"bands", bands}, {"bytes_in_bands", bytes}};
    write_atomically(o.stats, facts.dump(2) + "\n");
  }
  return done;
}

std::string explanation() {
  std::string text =
      "Words between two elements, from the left and all of one precedence: A over B over C is (A over B) over C.\n"
      "Words behind an element bind first; M is a file, (…) or a generator. A number may be keys: [1:0 24:1], linear\n"
      "from frame to frame. A file without . / # or % in its name needs quotes.\n";
  const auto list = [&](const char* title, Form form) {
    text += fmt::format("\n{}\n", title);
    for (const Word& word : all_words())
      if (word.form == form) text += fmt::format("  {:<52} {}\n", usage(word), word.summary);
  };
  list("Between two elements:", Form::infix);
  list("Behind an element:", Form::postfix);
  list("Generators:", Form::generator);
  return text +
         "\nTry:\n"
         "  lambert composite 'fg.exr over (sky.exr opaque 0.7)' -o out.exr\n"
         "  lambert composite 'title.png over (mug.exr over plate.####.exr)' --frames 1-48 -o out.####.exr\n"
         "  lambert composite 'disk(64,64,40) xor rectangle(60,60,60,60)' --resolution 128x128 -o shape.png";
}

}  // namespace

std::function<int()> add_composite(CLI::App& app) {
  static Options options;
  app.add_option("expression", options.expression,
                 "What to composite: an expression, or a file of one: FILE.comp, or FILE.json as a tree")
      ->required();
  add_outputs(app, options.outputs, "The picture to write, by extension");
  app.add_option("--frames", options.frames, "FIRST-LAST, FIRST-LASTxSTEP; parted by commas; fills in #### or %04d");
  app.add_option("--resolution", options.resolution, "Show WIDTHxHEIGHT pixels from (0, 0) instead of what B shows");
  app.add_option("--depth", options.depth, "How numbers are stored: auto, 8, 16, half, float");
  app.add_option("--compression", options.compression, "Of OpenEXR files: zip (default), none, rle, zips, piz, …");
  app.add_option("--print", options.print, "Print the tree as 'text' or 'json' instead of compositing")
      ->check(CLI::IsMember({"text", "json"}));
  add_output(app, "--stats", options.stats, "Write times and memory as JSON");
  expect_number(app.add_option("--threads", options.threads, "Threads; 0 is one for each processor"),
                {.expected = "a number from 0 to 1024", .below = 1025});
  add_work_options(app, options.work);
  app.footer(explanation());
  return [] { return run(options); };
}

}  // namespace lambert::cli
