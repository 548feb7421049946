#include "lambert/image/composite/language.h"

#include "lambert/base/number.h"

#include <algorithm>

namespace lambert::composite {
namespace {

constexpr double most = 1e9;  // as large as a number of pixels, a frame or a light may sensibly be

using Default = std::optional<double>;
constexpr Parameter any(std::string_view name, Default otherwise = {}) { return {name, -most, most, otherwise}; }
constexpr Parameter from_zero(std::string_view name, Default otherwise = {}) { return {name, 0, most, otherwise}; }
constexpr Parameter fraction(std::string_view name, Default otherwise = {}) { return {name, 0, 1, otherwise}; }
constexpr Parameter radius(std::string_view name) { return {name, 0, 2000}; }

using enum Form;
constexpr bool second = true, more = true;
constexpr std::string_view no_text;

/// Name, verb, form, summary, numbers, what a name names, whether there is a second element, whether there is more.
constexpr Word words[] = {
    {"clear", Verb::clear, infix, "nothing"},
    {"a", Verb::a, infix, "A alone"},
    {"b", Verb::b, infix, "B alone"},
    {"over", Verb::over, infix, "A before B"},
    {"rover", Verb::rover, infix, "B before A"},
    {"in", Verb::in, infix, "A where B is"},
    {"rin", Verb::rin, infix, "B where A is"},
    {"out", Verb::out, infix, "A where B is not"},
    {"rout", Verb::rout, infix, "B where A is not"},
    {"atop", Verb::atop, infix, "A on B, where B is"},
    {"ratop", Verb::ratop, infix, "B on A, where A is"},
    {"xor", Verb::exclusive_or, infix, "each where the other is not"},
    {"plus", Verb::plus, infix, "A + B in every channel"},
    {"zover", Verb::zover, infix, "the nearer by Z before the other, pixel by pixel"},
    {"minus", Verb::minus, infix, "A - B in every channel"},
    {"difference", Verb::difference, infix, "|A - B| in every channel"},
    {"max", Verb::max, infix, "the larger in every channel"},
    {"min", Verb::min, infix, "the smaller in every channel"},

    {"mask", Verb::mask, postfix, "what M's matte covers", {}, no_text, second},
    {"stencil", Verb::stencil, postfix, "what M's matte leaves", {}, no_text, second},
    {"multiply", Verb::multiply, postfix, "A M in every channel", {}, no_text, second},
    {"screen", Verb::screen, postfix, "A + M - A M", {}, no_text, second},
    {"matte", Verb::matte, postfix, "alpha, or the luminance of what has none"},
    {"invert", Verb::invert, postfix, "the matte of all that A is not"},
    {"luminance",
     Verb::luminance,
     postfix,
     "a matte, 0 up to a luminance of low, 1 from high on",
     {any("low", 0), any("high", 1)}},
    {"channel",
     Verb::channel,
     postfix,
     "a matte of one channel, 0 up to low, 1 from high on",
     {any("low", 0), any("high", 1)},
     "channel"},
    {"depth-matte", Verb::depth_matte, postfix, "a matte of Z, 0 up to near, 1 from far on", {any("near"), any("far")}},
    {"key-colour",
     Verb::key_colour,
     postfix,
     "what has not the backing's hue",
     {from_zero("r"), from_zero("g"), from_zero("b"), from_zero("inner", 0.1), from_zero("outer", 1),
      fraction("spill", 1)}},
    {"key-screen",
     Verb::key_screen,
     postfix,
     "what is before a blue or green backing",
     {from_zero("r"), from_zero("g"), from_zero("b"), from_zero("low", 0), from_zero("high", 1), fraction("spill", 1)}},
    {"key-difference",
     Verb::key_difference,
     postfix,
     "what differs from the clean plate M",
     {from_zero("low", 0.02), from_zero("high", 0.1)},
     no_text,
     second},
    {"despill",
     Verb::despill,
     postfix,
     "the light of a backing held back",
     {from_zero("r"), from_zero("g"), from_zero("b"), fraction("amount", 1)}},
    {"blur", Verb::blur, postfix, "Gaussian of a standard deviation in pixels", {radius("sigma")}},
    {"erode", Verb::erode, postfix, "the matte drawn in, colours kept", {radius("radius")}},
    {"dilate", Verb::dilate, postfix, "the matte drawn out", {radius("radius")}},
    {"edge", Verb::edge, postfix, "the matte of the edge: drawn out less drawn in", {radius("radius")}},

    {"darken", Verb::darken, postfix, "light times factor", {from_zero("factor")}},
    {"dissolve", Verb::dissolve, postfix, "light and alpha times amount", {fraction("amount")}},
    {"opaque", Verb::opaque, postfix, "alpha times amount", {fraction("amount")}},
    {"exposure", Verb::exposure, postfix, "light times 2^stops", {{"stops", -100, 100, {}}}},
    {"gain", Verb::gain, postfix, "each colour times its factor", {from_zero("r"), from_zero("g"), from_zero("b")}},
    {"saturation", Verb::saturation, postfix, "0 grey, 1 as it is", {from_zero("amount")}},
    {"clamp", Verb::clamp, postfix, "every channel to [0, 1]"},
    {"premultiply", Verb::premultiply, postfix, "light times alpha"},
    {"unpremultiply", Verb::unpremultiply, postfix, "light by alpha"},
    {"translate", Verb::translate, postfix, "moved right and down; between pixels linear", {any("x"), any("y")}},
    {"crop",
     Verb::crop,
     postfix,
     "what lies in a rectangle of whole pixels",
     {any("x"), any("y"), from_zero("width"), from_zero("height")}},
    {"layer", Verb::layer, postfix, "the channels NAME.R, NAME.G, NAME.B as the colour", {}, "layer"},
    {"frame", Verb::frame, postfix, "A as it is at another frame", {any("number")}},

    {"colour",
     Verb::colour,
     generator,
     "the same pixel everywhere, premultiplied",
     {any("r"), any("g"), any("b"), fraction("a", 1)}},
    {"disk",
     Verb::disk,
     generator,
     "a matte about (x, y), which falls off over `softness` pixels",
     {any("x"), any("y"), from_zero("radius"), from_zero("softness", 1)}},
    {"rectangle", Verb::rectangle, generator, "a matte", {any("x"), any("y"), from_zero("width"), from_zero("height")}},
    {"gradient",
     Verb::gradient,
     generator,
     "a matte everywhere, 0 at (x0, y0), 1 at (x1, y1)",
     {any("x0"), any("y0"), any("x1"), any("y1")}},
    {"polygon",
     Verb::polygon,
     generator,
     "a matte by the exact area of each pixel inside",
     {any("x0"), any("y0"), any("x1"), any("y1"), any("x2"), any("y2")},
     no_text,
     !second,
     more},
};

}  // namespace

std::span<const Word> all_words() { return words; }

const Word* find_word(std::string_view name) {
  const auto* found = std::ranges::find(words, name, &Word::name);
  return found == std::end(words) ? nullptr : found;
}

std::vector<std::string> word_names(Form form) {
  std::vector<std::string> names;
  for (const Word& w : words)
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
