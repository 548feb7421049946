#include "lambert/draw/stroke_font.h"

#include <algorithm>
#include <array>

namespace lambert::draw {
namespace {

/// Each character from ' ' to '~' as strokes, with a blank between them: the points of a grid, two digits each, x to
/// the right and y up. The base line is y = 2, capitals reach y = 8, small letters y = 6, tails y = 0.
constexpr std::array<std::string_view, 95> glyphs = {"",
                                                     "0804 0202",
                                                     "0806 1816",
                                                     "1218 3238 0444 0646",
                                                     "0208484202",
                                                     "0248 0818170708 3343423233",
                                                     "42171828270403122244",
                                                     "0806",
                                                     "18060412",
                                                     "08161402",
                                                     "2327 0446 0644",
                                                     "2327 0545",
                                                     "1301",
                                                     "0535",
                                                     "0212130302",
                                                     "0238",
                                                     "120307183847433212",
                                                     "172822 1232",
                                                     "07183847460242",
                                                     "0718384746354443321203 1535",
                                                     "32380444",
                                                     "480805354443321203",
                                                     "473818070312324344351504",
                                                     "084812",
                                                     "15060718384746351504031232434435",
                                                     "031232434738180706153546",
                                                     "0212130302 0515160605",
                                                     "1301 1515",
                                                     "370533",
                                                     "0636 0434",
                                                     "073503",
                                                     "07183847462524 2222",
                                                     "0208484202",
                                                     "022842 1535",
                                                     "02083847463505 3544433202",
                                                     "4738180703123243",
                                                     "02082846442202",
                                                     "48080242 0535",
                                                     "480802 0535",
                                                     "47381807031232434525",
                                                     "0802 4842 0545",
                                                     "0802",
                                                     "3833221203",
                                                     "0802 4804 1542",
                                                     "080242",
                                                     "0208244842",
                                                     "02084248",
                                                     "120307183847433212",
                                                     "02083847453404",
                                                     "120307183847433212 2442",
                                                     "02083847463505 2542",
                                                     "473818070615354443321203",
                                                     "0848 2822",
                                                     "080312324348",
                                                     "082248",
                                                     "0812263248",
                                                     "0842 0248",
                                                     "082548 2522",
                                                     "08480242",
                                                     "18080212",
                                                     "0832",
                                                     "08181202",
                                                     "062846",
                                                     "0141",
                                                     "0208484202",
                                                     "3632 3526160503122233",
                                                     "0802 0516263533221203",
                                                     "3526160503122233",
                                                     "3832 3526160503122233",
                                                     "043435261605031232",
                                                     "281712 0626",
                                                     "3631201001 3526160503122233",
                                                     "0802 0516263532",
                                                     "0602 0808",
                                                     "161100 1818",
                                                     "0802 3603 1432",
                                                     "0802",
                                                     "0602 05162522 25364542",
                                                     "0602 0516263532",
                                                     "162635332212030516",
                                                     "0600 0516263533221203",
                                                     "3630 3526160503122233",
                                                     "0602 041626",
                                                     "35261605142433221203",
                                                     "181322 0626",
                                                     "0603122233 3632",
                                                     "062246",
                                                     "0612243246",
                                                     "0632 0236",
                                                     "0622 4610",
                                                     "06360232",
                                                     "0208484202",
                                                     "0800",
                                                     "0208484202",
                                                     "04153445"};

constexpr std::string_view unknown = "0208484202";
constexpr double base = 2, units_per_size = 6 / 0.7, gap = 1.7;

std::string_view glyph(char c) { return c >= ' ' && c <= '~' ? glyphs[static_cast<std::size_t>(c - ' ')] : unknown; }

double digit(char c) { return c - '0'; }

double width(std::string_view strokes) {
  if (strokes.empty()) return 1.3;
  double widest = 0;
  for (std::size_t i = 0; i < strokes.size(); i += strokes[i] == ' ' ? 1 : 2)
    if (strokes[i] != ' ') widest = std::max(widest, digit(strokes[i]));
  return widest;
}

}  // namespace

std::vector<Ring> text_strokes(std::string_view text, Vec2d at, double size) {
  std::vector<Ring> strokes;
  const double unit = size / units_per_size;
  for (const char c : text) {
    const std::string_view shape = glyph(c);
    bool begins = true;
    for (std::size_t i = 0; i < shape.size();) {
      if (shape[i] == ' ') {
        begins = true;
        ++i;
        continue;
      }
      if (begins) strokes.emplace_back();
      begins = false;
      strokes.back().push_back({at.x + unit * digit(shape[i]), at.y - unit * (digit(shape[i + 1]) - base)});
      i += 2;
    }
    at.x += unit * (width(shape) + gap);
  }
  return strokes;
}

double text_width(std::string_view text, double size) {
  double units = 0;
  for (const char c : text) units += width(glyph(c)) + gap;
  return std::max(0.0, units - gap) * size / units_per_size;
}

}  // namespace lambert::draw
