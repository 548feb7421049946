#include "lambert/image/composite/language.h"

#include "lambert/base/number.h"

#include <algorithm>

namespace lambert::composite {
namespace {

constexpr double most = 1e9;  // as large as a number of pixels, a frame or a light may sensibly be

Parameter any(std::string_view name) { return {name, -most, most, {}}; }
Parameter from_zero(std::string_view name) { return {name, 0, most, {}}; }
Parameter fraction(std::string_view name) { return {name, 0, 1, {}}; }
Parameter radius(std::string_view name) { return {name, 0, 2000, {}}; }
Parameter with_default(Parameter p, double value) {
  p.otherwise = value;
  return p;
}

std::vector<Word> make_words() {
  using enum Form;
  return {
      {"clear", Verb::clear, infix, "nothing", {}},
      {"a", Verb::a, infix, "A alone", {}},
      {"b", Verb::b, infix, "B alone", {}},
      {"over", Verb::over, infix, "A before B", {}},
      {"rover", Verb::rover, infix, "B before A", {}},
      {"in", Verb::in, infix, "A where B is", {}},
      {"rin", Verb::rin, infix, "B where A is", {}},
      {"out", Verb::out, infix, "A where B is not", {}},
      {"rout", Verb::rout, infix, "B where A is not", {}},
      {"atop", Verb::atop, infix, "A on B, where B is", {}},
      {"ratop", Verb::ratop, infix, "B on A, where A is", {}},
      {"xor", Verb::exclusive_or, infix, "each where the other is not", {}},
      {"plus", Verb::plus, infix, "A + B in every channel", {}},
      {"zover", Verb::zover, infix, "the nearer by Z before the other, pixel by pixel", {}},
      {"minus", Verb::minus, infix, "A - B in every channel", {}},
      {"difference", Verb::difference, infix, "|A - B| in every channel", {}},
      {"max", Verb::max, infix, "the larger in every channel", {}},
      {"min", Verb::min, infix, "the smaller in every channel", {}},

      {.name = "mask", .verb = Verb::mask, .form = postfix, .summary = "what M's matte covers", .second = true},
      {.name = "stencil", .verb = Verb::stencil, .form = postfix, .summary = "what M's matte leaves", .second = true},
      {.name = "multiply", .verb = Verb::multiply, .form = postfix, .summary = "A M in every channel", .second = true},
      {.name = "screen", .verb = Verb::screen, .form = postfix, .summary = "A + M - A M", .second = true},
      {.name = "matte", .verb = Verb::matte, .form = postfix, .summary = "alpha, or the luminance of what has none"},
      {.name = "invert", .verb = Verb::invert, .form = postfix, .summary = "the matte of all that A is not"},
      {.name = "luminance",
       .verb = Verb::luminance,
       .form = postfix,
       .summary = "a matte, 0 up to a luminance of low, 1 from high on",
       .parameters = {with_default(any("low"), 0), with_default(any("high"), 1)}},
      {.name = "channel",
       .verb = Verb::channel,
       .form = postfix,
       .summary = "a matte of one channel, 0 up to low, 1 from high on",
       .parameters = {with_default(any("low"), 0), with_default(any("high"), 1)},
       .text = "channel"},
      {.name = "depth-matte",
       .verb = Verb::depth_matte,
       .form = postfix,
       .summary = "a matte of Z, 0 up to near, 1 from far on",
       .parameters = {any("near"), any("far")}},
      {.name = "key-colour",
       .verb = Verb::key_colour,
       .form = postfix,
       .summary = "what has not the backing's hue",
       .parameters = {from_zero("r"), from_zero("g"), from_zero("b"), with_default(from_zero("inner"), 0.1),
                      with_default(from_zero("outer"), 1), with_default(fraction("spill"), 1)}},
      {.name = "key-screen",
       .verb = Verb::key_screen,
       .form = postfix,
       .summary = "what is before a blue or green backing",
       .parameters = {from_zero("r"), from_zero("g"), from_zero("b"), with_default(from_zero("low"), 0),
                      with_default(from_zero("high"), 1), with_default(fraction("spill"), 1)}},
      {.name = "key-difference",
       .verb = Verb::key_difference,
       .form = postfix,
       .summary = "what differs from the clean plate M",
       .parameters = {with_default(from_zero("low"), 0.02), with_default(from_zero("high"), 0.1)},
       .second = true},
      {.name = "despill",
       .verb = Verb::despill,
       .form = postfix,
       .summary = "the light of a backing held back",
       .parameters = {from_zero("r"), from_zero("g"), from_zero("b"), with_default(fraction("amount"), 1)}},
      {.name = "blur",
       .verb = Verb::blur,
       .form = postfix,
       .summary = "Gaussian of a standard deviation in pixels",
       .parameters = {radius("sigma")}},
      {.name = "erode",
       .verb = Verb::erode,
       .form = postfix,
       .summary = "the matte drawn in, colours kept",
       .parameters = {radius("radius")}},
      {.name = "dilate",
       .verb = Verb::dilate,
       .form = postfix,
       .summary = "the matte drawn out",
       .parameters = {radius("radius")}},
      {.name = "edge",
       .verb = Verb::edge,
       .form = postfix,
       .summary = "the matte of the edge: drawn out less drawn in",
       .parameters = {radius("radius")}},

      {.name = "darken",
       .verb = Verb::darken,
       .form = postfix,
       .summary = "light times factor",
       .parameters = {from_zero("factor")}},
      {.name = "dissolve",
       .verb = Verb::dissolve,
       .form = postfix,
       .summary = "light and alpha times amount",
       .parameters = {fraction("amount")}},
      {.name = "opaque",
       .verb = Verb::opaque,
       .form = postfix,
       .summary = "alpha times amount",
       .parameters = {fraction("amount")}},
      {.name = "exposure",
       .verb = Verb::exposure,
       .form = postfix,
       .summary = "light times 2^stops",
       .parameters = {{"stops", -100, 100, {}}}},
      {.name = "gain",
       .verb = Verb::gain,
       .form = postfix,
       .summary = "each colour times its factor",
       .parameters = {from_zero("r"), from_zero("g"), from_zero("b")}},
      {.name = "saturation",
       .verb = Verb::saturation,
       .form = postfix,
       .summary = "0 grey, 1 as it is",
       .parameters = {from_zero("amount")}},
      {.name = "clamp", .verb = Verb::clamp, .form = postfix, .summary = "every channel to [0, 1]"},
      {.name = "premultiply", .verb = Verb::premultiply, .form = postfix, .summary = "light times alpha"},
      {.name = "unpremultiply", .verb = Verb::unpremultiply, .form = postfix, .summary = "light by alpha"},
      {.name = "translate",
       .verb = Verb::translate,
       .form = postfix,
       .summary = "moved right and down; between pixels linear",
       .parameters = {any("x"), any("y")}},
      {.name = "crop",
       .verb = Verb::crop,
       .form = postfix,
       .summary = "what lies in a rectangle of whole pixels",
       .parameters = {any("x"), any("y"), from_zero("width"), from_zero("height")}},
      {.name = "layer",
       .verb = Verb::layer,
       .form = postfix,
       .summary = "the channels NAME.R, NAME.G, NAME.B as the colour",
       .text = "layer"},
      {.name = "frame",
       .verb = Verb::frame,
       .form = postfix,
       .summary = "A as it is at another frame",
       .parameters = {any("number")}},

      {.name = "colour",
       .verb = Verb::colour,
       .form = generator,
       .summary = "the same pixel everywhere, premultiplied",
       .parameters = {any("r"), any("g"), any("b"), with_default(fraction("a"), 1)}},
      {.name = "disk",
       .verb = Verb::disk,
       .form = generator,
       .summary = "a matte about (x, y), which falls off over `softness` pixels",
       .parameters = {any("x"), any("y"), from_zero("radius"), with_default(from_zero("softness"), 1)}},
      {.name = "rectangle",
       .verb = Verb::rectangle,
       .form = generator,
       .summary = "a matte",
       .parameters = {any("x"), any("y"), from_zero("width"), from_zero("height")}},
      {.name = "gradient",
       .verb = Verb::gradient,
       .form = generator,
       .summary = "a matte everywhere, 0 at (x0, y0), 1 at (x1, y1)",
       .parameters = {any("x0"), any("y0"), any("x1"), any("y1")}},
      {.name = "polygon",
       .verb = Verb::polygon,
       .form = generator,
       .summary = "a matte by the exact area of each pixel inside",
       .parameters = {any("x0"), any("y0"), any("x1"), any("y1"), any("x2"), any("y2")},
       .more = true},
  };
}

const std::vector<Word>& words() {
  static const std::vector<Word> table = make_words();
  return table;
}

}  // namespace

std::span<const Word> all_words() { return words(); }

const Word* find_word(std::string_view name) {
  const auto found = std::find_if(words().begin(), words().end(), [&](const Word& w) { return w.name == name; });
  return found == words().end() ? nullptr : &*found;
}

std::vector<std::string> word_names(Form form) {
  std::vector<std::string> names;
  for (const Word& w : words())
    if (w.form == form) names.emplace_back(w.name);
  return names;
}

std::string usage(const Word& word) {
  const bool call = word.form == Form::generator;
  std::string text = call ? std::string(word.name) + "(" : "A " + std::string(word.name);
  if (word.form == Form::infix) text += " B";
  if (!word.text.empty()) text += " NAME";
  if (word.second) text += " M";
  bool first = true;
  for (const Parameter& p : word.parameters) {
    text += call ? (first ? "" : ", ") : " ";
    text += p.otherwise ? "[" + std::string(p.name) + "=" + number_text(*p.otherwise) + "]" : std::string(p.name);
    first = false;
  }
  if (word.more) text += ", …";
  return text + (call ? ")" : "");
}

}  // namespace lambert::composite
