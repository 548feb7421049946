#include "lambert/base/number.h"
#include "lambert/polygon/formats/coordinates.h"
#include "lambert/polygon/formats/geojson.h"
#include "lambert/polygon/formats/path_builder.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon {
namespace {

const std::vector<std::string> geometry_types = {"Point",   "MultiPoint",   "LineString",        "MultiLineString",
                                                 "Polygon", "MultiPolygon", "GeometryCollection"};

Feature geometry_of(const std::string& type, const Coordinates& c) {
  if (type == "Point") return c.as_points(Nesting::position);
  if (type == "MultiPoint") return c.as_points(Nesting::path);
  if (type == "LineString") return c.as_lines(Nesting::path);
  if (type == "MultiLineString") return c.as_lines(Nesting::paths);
  if (type == "Polygon") return c.as_polygons(Nesting::paths);
  return c.as_polygons(Nesting::polygons);
}

Feature bare_coordinates(const Coordinates& c) {
  if (c.nesting() == Nesting::position) return c.as_points(Nesting::position);
  return c.as_polygons(c.nesting() == Nesting::unknown ? Nesting::paths : c.nesting());
}

/// An object of the file that is a geometry, a feature or a collection: which one, its "type" says in its own time.
struct Object {
  std::size_t begin = 0;
  std::string key, type, name;
  TextRange type_at;
  bool has_coordinates = false, has_children = false;
  Coordinates coordinates;
  std::vector<Feature> children;
  std::vector<JsonMember> members;
};

class Reader : public JsonEvents {
 public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Features take() { return std::move(result_); }

  void null(TextRange at) override { scalar(at, "null"); }
  void boolean(bool, TextRange at) override { scalar(at, at.in(text_)); }
  void number(double value, TextRange at) override {
    if (!in_coordinates()) return scalar(at, at.in(text_));
    placed([&] { coordinates().number(value, at); });
  }
  void string(std::string value, TextRange at) override {
    if (opaque_depth_ == 0 && !objects_.empty() && !in_coordinates() && !in_list_ && object().key == "type") {
      object().type = std::move(value);
      object().type_at = at;
      return;
    }
    if (is_name_) object().name = std::move(value);
    scalar(at, at.in(text_));
  }

  void key(std::string key, TextRange) override {
    is_name_ = opaque_depth_ == 1 && object().key == "properties" && key == "name";
    if (opaque_depth_ == 0) object().key = std::move(key);
  }

  void begin_array(TextRange at) override {
    if (opaque_depth_ > 0) return begin_opaque(at);
    if (objects_.empty() && !in_coordinates()) bare_ = true;
    if (in_coordinates()) return placed([&] { coordinates().begin_array(at); });
    if (in_list_) unexpected("an object", at);
    const std::string& key = object().key;
    if (key == "coordinates") {
      object().has_coordinates = true;
      object().coordinates = {};
      placed([&] { coordinates().begin_array(at); });
    } else if (key == "features" || key == "geometries") {
      in_list_ = true;
      object().has_children = true;
    } else {
      begin_opaque(at);
    }
  }
  void end_array(TextRange at) override {
    if (opaque_depth_ > 0) return end_opaque(at);
    if (!in_coordinates()) {
      in_list_ = false;
      return;
    }
    placed([&] { coordinates().end_array(at); });
    if (bare_ && !coordinates().open())
      placed([&] { result_.features.push_back(bare_coordinates(bare_coordinates_)); });
  }

  void begin_object(TextRange at) override {
    if (opaque_depth_ > 0) return begin_opaque(at);
    if (in_coordinates()) placed([&] { coordinates().other("{", at); });
    if (objects_.empty() || in_list_ || object().key == "geometry") {
      if (!objects_.empty()) object().has_children = true;
      was_in_list_.push_back(in_list_);
      objects_.emplace_back().begin = at.begin;
      in_list_ = false;
    } else {
      begin_opaque(at);
    }
  }
  void end_object(TextRange at) override {
    if (opaque_depth_ > 0) return end_opaque(at);
    Object finished = std::move(objects_.back());
    objects_.pop_back();
    in_list_ = was_in_list_.back();
    was_in_list_.pop_back();
    finish(std::move(finished));
  }

 private:
  Object& object() { return objects_.back(); }
  bool in_coordinates() const {
    return bare_ || (!objects_.empty() && opaque_depth_ == 0 && objects_.back().coordinates.open());
  }
  Coordinates& coordinates() { return bare_ ? bare_coordinates_ : object().coordinates; }

  [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
    throw Error(location_in(text_, name_, offset), feature_words_ + message);
  }
  [[noreturn]] void unexpected(const std::string& expected, TextRange at) {
    name_feature();
    fail(at.begin, "expected " + expected + ", found '" + printable(at.in(text_)) + "'");
  }
  /// Says which element of "features" is being read.
  void name_feature() {
    if (objects_.empty()) return;
    const Object& root = objects_.front();
    if (root.key == "features" && (objects_.size() > 1 || in_list_))
      feature_words_ = "feature " + std::to_string(root.children.size()) + ": ";
  }
  template <class F>
  void placed(F&& f) {
    try {
      f();
    } catch (const Coordinates::Complaint& complaint) {
      name_feature();
      fail(complaint.offset, complaint.message);
    }
  }

  void scalar(TextRange at, std::string_view found) {
    if (opaque_depth_ > 0) return;
    if (objects_.empty() && !bare_) fail(at.begin, "expected a GeoJSON object, found '" + printable(found) + "'");
    if (in_coordinates()) placed([&] { coordinates().other(found, at); });
    if (in_list_) unexpected("an object", at);
    const std::string& key = object().key;
    if (key == "geometry" && found == "null") return;
    if (key == "type") unexpected("a word", at);
    if (key == "coordinates" || key == "features" || key == "geometries") unexpected("an array for '" + key + "'", at);
    if (key == "geometry") unexpected("an object for 'geometry'", at);
    object().members.push_back({key, std::string(at.in(text_))});
  }
  void begin_opaque(TextRange at) {
    if (opaque_depth_++ == 0) opaque_begin_ = at.begin;
    is_name_ = false;
  }
  void end_opaque(TextRange at) {
    if (--opaque_depth_ > 0) return;
    object().members.push_back({object().key, std::string(text_.substr(opaque_begin_, at.end - opaque_begin_))});
  }

  void finish(Object o) {
    const bool is_root = objects_.empty();
    const auto complain = [&](std::size_t offset, const std::string& message) {
      name_feature();
      fail(offset, message);
    };
    if (o.type.empty()) complain(o.begin, "expected a 'type' in this object");
    std::vector<Feature>& out = is_root ? result_.features : object().children;
    if (o.type == "FeatureCollection") {
      if (!o.has_children) complain(o.begin, "expected 'features' in this FeatureCollection");
      if (is_root) result_.members = std::move(o.members);
      std::move(o.children.begin(), o.children.end(), std::back_inserter(out));
    } else if (o.type == "Feature" || o.type == "GeometryCollection") {
      if (o.has_coordinates) complain(o.begin, "expected no 'coordinates' in a " + o.type + ", but in its geometry");
      Feature feature;
      for (Feature& child : o.children) append(feature, std::move(child));
      if (o.type == "Feature") {
        feature.name = std::move(o.name);
        feature.members = std::move(o.members);
      }
      out.push_back(std::move(feature));
    } else if (std::find(geometry_types.begin(), geometry_types.end(), o.type) != geometry_types.end()) {
      if (!o.has_coordinates) complain(o.begin, "expected 'coordinates' in this " + o.type);
      placed([&] { out.push_back(geometry_of(o.type, o.coordinates)); });
    } else {
      std::vector<std::string> known = geometry_types;
      known.insert(known.end(), {"Feature", "FeatureCollection"});
      complain(o.type_at.begin, "unknown type " + unknown_word(printable(o.type), known));
    }
  }

  std::string_view text_;
  const std::string& name_;
  Features result_;
  std::vector<Object> objects_;    // open ones
  std::vector<bool> was_in_list_;  // where each of them stands
  bool in_list_ = false;           // of features or geometries
  bool is_name_ = false;           // the next value is properties.name
  bool bare_ = false;              // the file is an array
  Coordinates bare_coordinates_;
  std::size_t opaque_depth_ = 0, opaque_begin_ = 0;
  std::string feature_words_;
};

}  // namespace

Features parse_geojson(std::string_view text, const std::string& name) {
  Reader reader(text, name);
  parse_json_events(text, name, reader);
  return reader.take();
}

}  // namespace lambert::polygon
