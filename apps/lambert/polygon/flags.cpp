#include "verb.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;

std::vector<double> parse_reals(const std::string& flag, const std::string& text, std::size_t count,
                                const std::string& expected) {
  const auto fail = [&] { throw Error(flag + ": expected " + expected + ", got '" + printable(text) + "'"); };
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  while (numbers.size() < count) {
    double value = 0;
    at = parse_double(at, end, value);
    if (!at) fail();
    numbers.push_back(value);
    if (numbers.size() == count) break;
    if (at == end || *at != ',') fail();
    ++at;
  }
  if (at != end) fail();
  return numbers;
}

void add_at_option(CLI::App& app, std::vector<std::string>& at) {
  app.add_option("--at", at, "A point X,Y of the data; several allowed")->type_name("X,Y")->allow_extra_args(false);
}

std::vector<Vec2d> parse_points(const std::string& flag, const std::vector<std::string>& texts) {
  std::vector<Vec2d> points;
  for (const std::string& text : texts) {
    const std::vector<double> n = parse_reals(flag, text, 2, "X,Y");
    points.emplace_back(n[0], n[1]);
  }
  return points;
}

Box2 parse_window(const std::string& flag, const std::string& text) {
  const std::vector<double> n = parse_reals(flag, text, 4, "x0,y0,x1,y1");
  const Box2 window{{n[0], n[1]}, {n[2], n[3]}};
  if (window.empty()) throw Error(flag + ": expected x0 <= x1 and y0 <= y1, got '" + text + "'");
  return window;
}

Vec2i parse_size(const std::string& flag, const std::string& text) {
  std::int64_t width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const char* at = parse_int(text.data(), end, width);
  if (at && at != end && *at == 'x') at = parse_int(at + 1, end, height);
  constexpr std::int64_t most = 16384;
  if (at != end || width < 1 || height < 1 || width > most || height > most)
    throw Error(flag + ": expected WIDTHxHEIGHT from 1 to 16384, got '" + printable(text) + "'");
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string point_text(Vec2d p) { return "(" + number_text(p.x) + ", " + number_text(p.y) + ")"; }

}  // namespace lambert::cli
