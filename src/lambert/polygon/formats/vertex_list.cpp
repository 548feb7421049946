#include "lambert/polygon/formats/vertex_list.h"

#include "lambert/base/error.h"
#include "lambert/base/lines.h"
#include "lambert/base/number.h"
#include "lambert/polygon/formats/path_builder.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

enum class Kind { ring, hole, line, points };

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class Reader {
 public:
  explicit Reader(const std::string& name) : name_(name) {}

  void line(std::string_view text, std::size_t number) {
    text_ = text.substr(0, text.find('#'));
    number_ = number;
    at_ = 0;
    skip_blanks();
    if (at_ == text_.size()) {
      if (text.size() == text_.size()) end(Kind::ring);  // a comment is no blank line
      return;
    }
    const std::string_view word = text_.substr(at_, text_.find_last_not_of(" \t\r") + 1 - at_);
    if (word == "hole") {
      end(Kind::hole);
    } else if (word == "line") {
      end(Kind::line);
    } else if (word == "points") {
      end(Kind::points);
    } else {
      positions_.push_back(position());
    }
  }

  Features take() {
    end(Kind::ring);
    Features result;
    result.features.push_back(std::move(feature_));
    return result;
  }

 private:
  void end(Kind next) {
    if (!positions_.empty()) {
      if (kind_ == Kind::points) {
        append(feature_.points, make_path(positions_));
      } else if (kind_ == Kind::line) {
        feature_.lines.push_back(make_path(positions_));
      } else {
        Path ring = make_closed_ring(positions_);
        ring.closed = true;
        if (kind_ == Kind::ring || feature_.polygons.empty()) feature_.polygons.emplace_back();
        feature_.polygons.back().push_back(std::move(ring));
      }
      positions_.clear();
    }
    kind_ = next;
  }

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  void skip_separator() {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == ',') ++at_;
    skip_blanks();
  }

  Vec3d position() {
    Vec3d p(0, 0, no_height);
    p.x = number("a number (or 'hole', 'line', 'points')");
    skip_separator();
    p.y = number("a second number");
    skip_separator();
    if (at_ == text_.size()) return p;
    p.z = number("a third number or the line's end");
    skip_blanks();
    if (at_ < text_.size()) expected("the line's end");
    return p;
  }
  double number(const char* what) {
    double value = 0;
    const char* end = parse_double(text_.data() + at_, text_.data() + text_.size(), value);
    if (!end) expected(what);
    const auto after = static_cast<std::size_t>(end - text_.data());
    if (after < text_.size() && !is_blank(text_[after]) && text_[after] != ',') expected(what);
    at_ = after;
    return value;
  }
  [[noreturn]] void expected(const std::string& what) const {
    const std::size_t end = std::min(text_.find_first_of(" \t\r,", at_ + 1), text_.size());
    const std::string found =
        at_ >= text_.size() ? "the line's end" : "'" + printable(text_.substr(at_, end - at_)) + "'";
    throw Error(SourceLocation{name_, number_, at_ + 1}, place() + "expected " + what + ", found " + found);
  }
  std::string place() const {
    const std::string vertex = "vertex " + std::to_string(positions_.size()) + ": ";
    if (kind_ == Kind::points) return vertex;
    if (kind_ == Kind::line) return "line " + std::to_string(feature_.lines.size()) + ", " + vertex;
    const bool hole = kind_ == Kind::hole && !feature_.polygons.empty();
    const std::size_t polygon = feature_.polygons.size() - (hole ? 1 : 0);
    const std::size_t ring = hole ? feature_.polygons.back().size() : 0;
    return "polygon " + std::to_string(polygon) + ", ring " + std::to_string(ring) + ", " + vertex;
  }

  const std::string& name_;
  std::string_view text_;
  std::size_t number_ = 0, at_ = 0;
  Kind kind_ = Kind::ring;
  std::vector<Vec3d> positions_;
  Feature feature_;
};

class Writer {
 public:
  std::string take() { return std::move(text_); }

  void feature(const Feature& f) {
    if (!f.name.empty()) text_ += "# " + printable(f.name) + "\n";
    for (const PathPolygon& polygon : f.polygons) {
      separate();
      const char* word = "";
      for (const Path& ring : polygon) {
        path(ring, word);
        if (ends_as_it_begins(ring)) vertex(ring, 0);
        if (!ring.points.empty()) word = "hole\n";
      }
    }
    for (const Path& line : f.lines) path(line, "line\n");
    path(f.points, "points\n");
  }

 private:
  void separate() {
    if (has_vertices_) text_ += "\n";
    has_vertices_ = false;
  }
  void path(const Path& path, const char* word) {
    if (path.points.empty()) return;
    text_ += word;
    has_vertices_ = true;
    for (std::size_t i = 0; i < path.points.size(); ++i) vertex(path, i);
  }
  void vertex(const Path& path, std::size_t i) {
    append_number(text_, path.points[i].x);
    text_ += " ";
    append_number(text_, path.points[i].y);
    if (!path.heights.empty()) {
      text_ += " ";
      append_number(text_, path.heights[i]);
    }
    text_ += "\n";
  }
  /// The reader would drop the last vertex of such a ring: the first is written once more.
  static bool ends_as_it_begins(const Path& ring) {
    return ring.points.size() > 1 && ring.points.front() == ring.points.back() &&
           (ring.heights.empty() || ring.heights.front() == ring.heights.back());
  }

  std::string text_;
  bool has_vertices_ = false;
};

}  // namespace

Features parse_vertex_list(std::string_view text, const std::string& name) {
  Reader reader(name);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for_lines(text, [&](std::string_view line, std::size_t number) { reader.line(line, number); });
  return reader.take();
}

std::string vertex_list_text(const Features& features) {
  Writer writer;
  for (const Feature& feature : features.features) writer.feature(feature);
  return writer.take();
}

}  // namespace lambert::polygon
