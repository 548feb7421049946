#include "lambert/base/number.h"
#include "lambert/polygon/formats/wkt.h"

namespace lambert::polygon {
namespace {

/// Every vertex of these has one, and there is some: Z is said once for all of them.
class Heights {
 public:
  explicit Heights(const Path& path) { add(path); }
  explicit Heights(const std::vector<Path>& paths) {
    for (const Path& path : paths) add(path);
  }
  explicit Heights(const std::vector<PathPolygon>& polygons) {
    for (const PathPolygon& rings : polygons)
      for (const Path& ring : rings) add(ring);
  }
  bool everywhere() const { return some_ && !lacking_; }

 private:
  void add(const Path& path) {
    if (!path.points.empty()) (path.heights.empty() ? lacking_ : some_) = true;
  }
  bool some_ = false, lacking_ = false;
};

class Writer {
 public:
  std::string take() { return std::move(text_); }

  void feature(const Feature& f) {
    const int kinds = !f.points.points.empty() + !f.lines.empty() + !f.polygons.empty();
    if (kinds == 0) text_ += "GEOMETRYCOLLECTION EMPTY";
    if (kinds > 1) text_ += "GEOMETRYCOLLECTION (";
    const char* separator = "";
    const auto part = [&](bool present, auto&& write) {
      if (!present) return;
      text_ += separator;
      write();
      separator = ", ";
    };
    part(!f.points.points.empty(), [&] { points(f.points); });
    part(!f.lines.empty(), [&] { lines(f.lines); });
    part(!f.polygons.empty(), [&] { polygons(f.polygons); });
    if (kinds > 1) text_ += ")";
  }

  void text(const std::string& words) { text_ += words; }

 private:
  void begin(const char* name, bool many, bool heights) {
    z_ = heights;
    text_ += std::string(many ? "MULTI" : "") + name + (heights ? " Z " : " ");
  }
  void points(const Path& path) {
    begin("POINT", path.points.size() > 1, Heights(path).everywhere());
    positions(path, false);
  }
  void lines(const std::vector<Path>& paths) {
    begin("LINESTRING", paths.size() > 1, Heights(paths).everywhere());
    one_or_many(paths, [&](const Path& path) { positions(path, false); });
  }
  void polygons(const std::vector<PathPolygon>& all) {
    begin("POLYGON", all.size() > 1, Heights(all).everywhere());
    one_or_many(
        all, [&](const PathPolygon& rings) { list(rings, [&](const Path& ring) { positions(ring, ring.closed); }); });
  }

  template <class T, class F>
  void one_or_many(const std::vector<T>& items, F&& write) {
    if (items.size() == 1) {
      write(items[0]);
    } else {
      list(items, write);
    }
  }
  template <class T, class F>
  void list(const std::vector<T>& items, F&& write) {
    if (items.empty()) {
      text_ += "EMPTY";
      return;
    }
    const char* separator = "(";
    for (const T& item : items) {
      text_ += separator;
      write(item);
      separator = ", ";
    }
    text_ += ")";
  }
  void positions(const Path& path, bool repeat_first) {
    if (path.points.empty()) {
      text_ += "EMPTY";
      return;
    }
    const std::size_t count = path.points.size() + (repeat_first ? 1 : 0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = k % path.points.size();
      text_ += k == 0 ? "(" : ", ";
      append_number(text_, path.points[i].x);
      text_ += " ";
      append_number(text_, path.points[i].y);
      if (!z_) continue;
      text_ += " ";
      append_number(text_, path.heights[i]);
    }
    text_ += ")";
  }

  std::string text_;
  bool z_ = false;
};

}  // namespace

std::string wkt_text(const Features& features) {
  Writer writer;
  for (const Feature& feature : features.features) {
    if (features.srid) writer.text("SRID=" + std::to_string(*features.srid) + ";");
    writer.feature(feature);
    writer.text("\n");
  }
  return writer.take();
}

}  // namespace lambert::polygon
