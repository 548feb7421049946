#include "lambert/base/number.h"
#include "lambert/polygon/formats/geojson.h"

#include <nlohmann/json.hpp>

namespace lambert::polygon {
namespace {

std::string quoted(const std::string& word) {
  return nlohmann::json(word).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

class Writer {
 public:
  std::string take() { return std::move(text_); }

  void collection(const Features& features) {
    text_ += R"({"type":"FeatureCollection",)";
    for (const JsonMember& member : features.members) text_ += quoted(member.key) + ":" + member.json + ",";
    text_ += "\"features\":[";
    const char* separator = "\n";
    for (const Feature& f : features.features) {
      text_ += separator;
      feature(f);
      separator = ",\n";
    }
    text_ += "\n]}\n";
  }

 private:
  void feature(const Feature& f) {
    text_ += R"({"type":"Feature",)";
    bool properties = false;
    for (const JsonMember& member : f.members) {
      text_ += quoted(member.key) + ":" + member.json + ",";
      properties = properties || member.key == "properties";
    }
    if (!properties) text_ += "\"properties\":" + (f.name.empty() ? "null" : "{\"name\":" + quoted(f.name) + "}") + ",";
    text_ += "\"geometry\":";
    geometry(f);
    text_ += "}";
  }

  void geometry(const Feature& f) {
    const int kinds = !f.points.points.empty() + !f.lines.empty() + !f.polygons.empty();
    if (kinds == 0) text_ += "null";
    if (kinds > 1) text_ += R"({"type":"GeometryCollection","geometries":[)";
    const char* separator = "";
    const auto part = [&](bool present, auto&& write) {
      if (!present) return;
      text_ += separator;
      write();
      separator = ",";
    };
    part(!f.points.points.empty(), [&] { points(f.points); });
    part(!f.lines.empty(), [&] { lines(f.lines); });
    part(!f.polygons.empty(), [&] { polygons(f.polygons); });
    if (kinds > 1) text_ += "]}";
  }

  void points(const Path& path) {
    if (path.points.size() == 1) {
      text_ += R"({"type":"Point","coordinates":)";
      position(path, 0);
      text_ += "}";
    } else {
      text_ += R"({"type":"MultiPoint","coordinates":)";
      positions(path, false);
      text_ += "}";
    }
  }
  void lines(const std::vector<Path>& paths) {
    one_or_many("LineString", paths, [&](const Path& path) { positions(path, false); });
  }
  void polygons(const std::vector<PathPolygon>& all) {
    one_or_many("Polygon", all, [&](const PathPolygon& rings) {
      array(rings, [&](const Path& ring) { positions(ring, ring.closed && !ring.points.empty()); });
    });
  }

  template <class T, class F>
  void one_or_many(const std::string& type, const std::vector<T>& items, F&& write) {
    text_ += R"({"type":")" + (items.size() == 1 ? "" : std::string("Multi")) + type + R"(","coordinates":)";
    if (items.size() == 1) {
      write(items[0]);
    } else {
      array(items, write);
    }
    text_ += "}";
  }
  template <class T, class F>
  void array(const std::vector<T>& items, F&& write) {
    text_ += "[";
    const char* separator = "";
    for (const T& item : items) {
      text_ += separator;
      write(item);
      separator = ",";
    }
    text_ += "]";
  }

  void positions(const Path& path, bool repeat_first) {
    text_ += "[";
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      if (i > 0) text_ += ",";
      position(path, i);
    }
    if (repeat_first) {
      text_ += ",";
      position(path, 0);
    }
    text_ += "]";
  }
  void position(const Path& path, std::size_t i) {
    text_ += "[";
    append_number(text_, path.points[i].x);
    text_ += ",";
    append_number(text_, path.points[i].y);
    if (!path.heights.empty()) {
      text_ += ",";
      append_number(text_, path.heights[i]);
    }
    text_ += "]";
  }

  std::string text_;
};

}  // namespace

std::string geojson_text(const Features& features) {
  Writer writer;
  writer.collection(features);
  return writer.take();
}

}  // namespace lambert::polygon
