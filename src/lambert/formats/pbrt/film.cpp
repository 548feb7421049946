#include "lambert/formats/pbrt/film.h"

#include "lambert/formats/pbrt/old_syntax.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::pbrt {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

template <std::size_t N>
std::string_view look_up(const std::array<Entry, N>& table, std::string_view word) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.first == word; });
  return found == table.end() ? std::string_view() : found->second;
}
template <std::size_t N>
std::vector<std::string> keys(const std::array<Entry, N>& table) {
  std::vector<std::string> words;
  for (const Entry& e : table) words.emplace_back(e.first);
  return words;
}

/// pbrt's names, and the nearest of ours.
constexpr std::array<Entry, 7> samplers{{{"halton", "halton"},
                                         {"independent", "independent"},
                                         {"paddedsobol", "sobol"},
                                         {"pmj02bn", "blue-noise"},
                                         {"sobol", "sobol"},
                                         {"stratified", "stratified"},
                                         {"zsobol", "blue-noise"}}};
constexpr std::array<Entry, 5> light_samplers{
    {{"bvh", "tree"}, {"power", "power"}, {"uniform", "uniform"}, {"exhaustive", "tree"}, {"all", "tree"}}};
constexpr std::array<Entry, 11> integrators{{{"path", "path"},
                                             {"volpath", "path"},
                                             {"bdpt", "path"},
                                             {"mlt", "path"},
                                             {"sppm", "path"},
                                             {"lightpath", "path"},
                                             {"simplepath", "path"},
                                             {"simplevolpath", "path"},
                                             {"randomwalk", "path"},
                                             {"ambientocclusion", "path"},
                                             {"function", "path"}}};

int positive(const ParameterList& list, const char* name, int fallback) {
  const int value = list.integer(name, fallback);
  if (value < 1) list.fail(std::string("'") + name + "' must be at least 1");
  return value;
}

}  // namespace

Vec2i read_film(Context& context, const ParameterList& list, const std::string& type) {
  const std::vector<std::string> known{"rgb", "gbuffer"};
  if (type == "spectral") context.notes.add("film 'spectral' is done as 'rgb'");
  if (type != "rgb" && type != "gbuffer" && type != "spectral") {
    fail_unknown_type(list, "film", type, known, old_type_hint(type));
  }
  constexpr int largest = 1 << 16;
  const Vec2i resolution(positive(list, "xresolution", default_resolution.x),
                         positive(list, "yresolution", default_resolution.y));
  if (resolution.x > largest || resolution.y > largest) list.fail("the resolution exceeds 65536 pixels");
  if (const std::string file = list.string("filename", ""); !file.empty()) context.graph.settings.output = file;
  if (!list.numbers("cropwindow").empty() || !list.integers("pixelbounds").empty()) {
    context.notes.add("the film's crop is ignored: see the option --crop");
  }
  if (list.number("iso", 100) != 100 || list.number("exposuretime", 1) != 1 ||
      list.string("sensor", "cie1931") != "cie1931" || list.number("whitebalance", 0) != 0) {
    context.notes.add("the film's sensor is ignored: radiance is written as it arrives");
  }
  list.number("diagonal", 35);
  list.boolean("savefp16", true);
  return resolution;
}

void read_filter(Context& context, const ParameterList& list, const std::string& type) {
  FilterSettings filter;
  const auto radius = [&](float fallback) {
    filter.radius = {list.number("xradius", fallback), list.number("yradius", fallback)};
    if (!(filter.radius.x > 0 && filter.radius.y > 0)) list.fail("the radius must be above 0");
  };
  if (type == "box") {
    filter.kind = FilterKind::box;
    radius(0.5f);
  } else if (type == "triangle") {
    filter.kind = FilterKind::triangle;
    radius(2);
  } else if (type == "gaussian") {
    filter.kind = FilterKind::gaussian;
    radius(1.5f);
    filter.sigma = list.number("sigma", 0.5f);
  } else if (type == "mitchell") {
    filter.kind = FilterKind::mitchell;
    radius(2);
    filter.b = list.number("B", 1.0f / 3), filter.c = list.number("C", 1.0f / 3);
  } else if (type == "sinc") {
    filter.kind = FilterKind::lanczos;
    radius(4);
    filter.radius = Vec2(list.number("tau", 3));
    context.notes.add("pixel filter 'sinc' is done as 'lanczos' with the radius 'tau'");
  } else {
    fail_unknown_type(list, "pixel filter", type, {"box", "triangle", "gaussian", "mitchell", "sinc"});
  }
  context.graph.settings.filter = filter;
}

void read_sampler(Context& context, const ParameterList& list, const std::string& type) {
  const std::string_view ours = look_up(samplers, type);
  if (ours.empty()) fail_unknown_type(list, "sampler", type, keys(samplers), old_type_hint(type));
  context.graph.settings.sampler = std::string(ours);
  if (type == "stratified") {
    const std::int64_t x = positive(list, "xsamples", 4), y = positive(list, "ysamples", 4);
    if (x * y > 1 << 30) list.fail("asks for too many samples");
    context.graph.settings.samples_per_pixel = static_cast<int>(x * y);
    list.boolean("jitter", true);
  } else {
    context.graph.settings.samples_per_pixel = positive(list, "pixelsamples", 16);
    list.string("randomization", "");
  }
}

void read_integrator(Context& context, const ParameterList& list, const std::string& type) {
  if (look_up(integrators, type).empty()) {
    fail_unknown_type(list, "integrator", type, keys(integrators), old_type_hint(type));
  }
  if (type != "path") context.notes.add("integrator '" + type + "' is done as 'path'");
  const int depth = list.integer("maxdepth", 5);
  if (depth < 0) list.fail("'maxdepth' must not be negative");
  context.graph.settings.max_depth = depth;
  const std::string strategy = list.string("lightsampler", "bvh");
  const std::string_view ours = look_up(light_samplers, strategy);
  if (ours.empty()) list.fail("unknown light sampler " + unknown_word(strategy, keys(light_samplers)));
  context.graph.settings.light_strategy = std::string(ours);
  if (list.boolean("regularize", false)) context.notes.add("the integrator's 'regularize' is ignored");
}

}  // namespace lambert::pbrt
