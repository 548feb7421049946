#include "lambert/base/error.h"
#include "lambert/base/json_events.h"
#include "lambert/base/number.h"
#include "lambert/polygon/formats/path_builder.h"
#include "lambert/polygon/formats/wkt.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

const std::vector<std::string> geometry_names = {"POINT",   "MULTIPOINT",   "LINESTRING",        "MULTILINESTRING",
                                                 "POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"};
constexpr int max_nesting = 64;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

std::string upper_case(std::string_view word) {
  std::string upper(word);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text.starts_with("\xef\xbb\xbf")) at_ = 3;
  }

  Features file() {
    Features result;
    while (skip_separators(), at_ < text_.size()) {
      feature_ = result.features.size();
      prefix(result);
      Feature feature;
      geometry(feature, 0);
      result.features.push_back(std::move(feature));
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    std::string words = "feature " + std::to_string(feature_);
    if (polygon_) words += ", polygon " + std::to_string(*polygon_);
    if (ring_) words += ", ring " + std::to_string(*ring_);
    if (vertex_) words += ", vertex " + std::to_string(*vertex_);
    throw Error(location_in(text_, name_, at_), words + ": " + message);
  }
  [[noreturn]] void expected(const std::string& what) const {
    std::size_t end = at_;
    while (end < text_.size() && !is_space(text_[end]) && text_[end] != ',' && text_[end] != '(' && text_[end] != ')')
      ++end;
    if (at_ < text_.size() && end == at_) ++end;
    const std::string found = end == at_ ? "the end" : "'" + printable(text_.substr(at_, end - at_)) + "'";
    fail("expected " + what + ", found " + found);
  }

  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  void skip_separators() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ';')) ++at_;
  }
  bool next_is(char c) {
    skip_space();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool accept(char c) { return next_is(c) && (++at_, true); }
  /// The word ahead, in upper case; not consumed.
  std::string peek_word() {
    skip_space();
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    return upper_case(text_.substr(at_, std::min<std::size_t>(end - at_, 64)));
  }
  bool accept_word(std::string_view word) { return peek_word() == word && (at_ += word.size(), true); }

  void prefix(Features& result) {
    if (!accept_word("SRID")) return;
    std::int64_t srid = 0;
    if (!accept('=')) expected("'=' after SRID");
    skip_space();
    const char* end = parse_int(text_.data() + at_, text_.data() + text_.size(), srid);
    if (!end) expected("a whole number after SRID=");
    if (result.srid && result.srid != srid) fail("expected the same SRID in the whole file");
    at_ = static_cast<std::size_t>(end - text_.data());
    if (!accept(';')) expected("';' after the SRID");
    result.srid = srid;
  }

  void geometry(Feature& feature, int depth) {
    const std::size_t begin = (skip_space(), at_);
    std::string word = peek_word();
    if (word.empty()) expected("the name of a geometry, such as POLYGON");
    const auto known = [&](const std::string& w) {
      return std::ranges::find(geometry_names, w) != geometry_names.end();
    };
    std::string tag;
    at_ += word.size();
    for (const char* suffix : {"ZM", "Z", "M"}) {
      if (known(word) || !word.ends_with(suffix)) continue;
      const std::string stem = word.substr(0, word.size() - std::string_view(suffix).size());
      if (!known(stem)) continue;
      word = stem;
      tag = suffix;
    }
    if (!known(word)) {
      at_ = begin;
      fail("unknown geometry " + unknown_word(word, geometry_names));
    }
    for (const char* separate : {"ZM", "Z", "M"})
      if (tag.empty() && accept_word(separate)) tag = separate;
    if (tag.ends_with("M")) {
      at_ = begin;
      fail("measures (M) are not read");
    }
    tagged_z_ = tag == "Z";
    if (accept_word("EMPTY")) return;
    if (word == "GEOMETRYCOLLECTION") return collection(feature, depth);
    body(word, feature);
  }

  void collection(Feature& feature, int depth) {
    if (depth == max_nesting) fail("collections nested deeper than " + std::to_string(max_nesting));
    open();
    do geometry(feature, depth + 1);
    while (accept(','));
    close();
  }

  void body(const std::string& word, Feature& feature) {
    if (word == "POINT" || word == "MULTIPOINT") {
      append(feature.points, make_path(positions(word == "MULTIPOINT")));
    } else if (word == "LINESTRING") {
      feature.lines.push_back(make_path(positions(false)));
    } else if (word == "MULTILINESTRING") {
      list([&] { feature.lines.push_back(make_path(positions(false))); }, ring_);
    } else if (word == "POLYGON") {
      add(feature, rings());
    } else {
      list([&] { add(feature, rings()); }, polygon_);
    }
  }
  static void add(Feature& feature, PathPolygon&& rings) {
    if (!rings.empty()) feature.polygons.push_back(std::move(rings));
  }

  void open() {
    if (!accept('(')) expected("'(' or EMPTY");
  }
  void close() {
    if (!accept(')')) expected("',' or ')'");
  }
  /// A list in brackets, or EMPTY; `index` says in messages which item it is.
  template <class F>
  void list(F&& item, std::optional<std::size_t>& index) {
    if (accept_word("EMPTY")) return;
    open();
    index = 0;
    do {
      item();
      ++*index;
    } while (accept(','));
    --*index;
    close();
    index.reset();
  }
  PathPolygon rings() {
    PathPolygon rings;
    list([&] { rings.push_back(make_closed_ring(positions(false))); }, ring_);
    return rings;
  }
  std::vector<Vec3d> positions(bool maybe_in_brackets) {
    std::vector<Vec3d> positions;
    list(
        [&] {
          if (maybe_in_brackets && accept_word("EMPTY")) return;
          const bool bracket = maybe_in_brackets && accept('(');
          positions.push_back(position());
          if (bracket) close();
        },
        vertex_);
    return positions;
  }
  Vec3d position() {
    Vec3d p(0, 0, no_height);
    p.x = number("a number");
    p.y = number("a second number");
    skip_space();
    if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')') p.z = number("',' or ')' or a third number");
    if (tagged_z_ && std::isnan(p.z)) expected("a third number after Z");
    return p;
  }
  double number(const char* what) {
    skip_space();
    double value = 0;
    const char* end = parse_double(text_.data() + at_, text_.data() + text_.size(), value);
    if (!end) expected(what);
    const auto after = static_cast<std::size_t>(end - text_.data());
    if (after < text_.size() && !is_space(text_[after]) && text_[after] != ',' && text_[after] != ')') expected(what);
    at_ = after;
    return value;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, feature_ = 0;
  std::optional<std::size_t> polygon_, ring_, vertex_;
  bool tagged_z_ = false;
};

}  // namespace

bool looks_like_wkt(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  const std::string start = upper_case(text.substr(begin, 18));
  return start.starts_with("SRID") ||
         std::ranges::any_of(geometry_names, [&](const std::string& name) { return start.starts_with(name); });
}

Features parse_wkt(std::string_view text, const std::string& name) { return Reader(text, name).file(); }

}  // namespace lambert::polygon
