#pragma once
/// The words of compositing expressions, in one table that parser, printer, JSON and evaluation share.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::composite {

enum class Form {
  infix,      ///< A word B
  postfix,    ///< A word numbers…, perhaps with a name or a second element
  generator,  ///< word(numbers…)
};

/// What a word does; the evaluation has a case for each.
enum class Verb : std::uint8_t {
  // infix: clear … plus are Operator's, in its order
  clear,
  a,
  b,
  over,
  rover,
  in,
  rin,
  out,
  rout,
  atop,
  ratop,
  exclusive_or,
  plus,
  zover,
  minus,
  difference,
  max,
  min,
  // postfix with a second element
  multiply,
  screen,
  mask,
  stencil,
  key_difference,
  // postfix
  darken,
  dissolve,
  opaque,
  premultiply,
  unpremultiply,
  clamp,
  exposure,
  gain,
  saturation,
  invert,
  matte,
  luminance,
  channel,
  depth_matte,
  key_colour,
  key_screen,
  despill,
  blur,
  erode,
  dilate,
  edge,
  translate,
  crop,
  layer,
  frame,
  // generators
  colour,
  disk,
  rectangle,
  gradient,
  polygon,
};

/// A number that a word takes; with `otherwise` it may be left out and is given as name=value.
struct Parameter {
  std::string_view name;
  double low = 0, high = 0;  ///< the range, ends included
  std::optional<double> otherwise = std::nullopt;
};

/// Those without a default first.
class Parameters {
 public:
  constexpr Parameters(std::initializer_list<Parameter> list) : count_(list.size()) {
    std::ranges::copy(list, all_.begin());
  }
  constexpr std::size_t size() const { return count_; }
  constexpr bool empty() const { return count_ == 0; }
  constexpr const Parameter* begin() const { return all_.data(); }
  constexpr const Parameter* end() const { return all_.data() + count_; }
  constexpr const Parameter& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::array<Parameter, 6> all_{};
  std::size_t count_;
};

struct Word {
  std::string_view name;
  Verb verb;
  Form form;
  std::string_view summary;
  Parameters parameters = {};
  std::string_view text = {};  ///< what the name it takes names; empty: it takes none
  bool second = false;         ///< a postfix word that takes an element
  bool more = false;           ///< any number of further pairs of numbers, as those before
};

/// All words in the order in which they are explained.
std::span<const Word> all_words();
/// Null when there is none.
const Word* find_word(std::string_view name);
std::vector<std::string> word_names(Form form);
/// How it is typed: "A key-colour r g b [inner=0.1] …".
std::string usage(const Word& word);

}  // namespace lambert::composite
