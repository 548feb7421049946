#pragma once
/// The nested arrays of numbers under "coordinates" in GeoJSON, whose meaning only the "type" says, which may follow.

#include "lambert/base/json_events.h"
#include "lambert/polygon/formats/features.h"

#include <array>
#include <string>
#include <vector>

namespace lambert::polygon {

/// How deep the numbers lie: [x, y] is 1, a ring 2, a polygon 3, a multi-polygon 4.
enum class Nesting : std::size_t { unknown, position, path, paths, polygons };

/// Takes the events of one such array and keeps its positions flat. Errors are thrown as messages without a place,
/// which the reader adds.
class Coordinates {
 public:
  /// What went wrong, and where among the arrays: "polygon 0, ring 2, vertex 7: expected a number, found 'null'".
  struct Complaint {
    std::string message;
    std::size_t offset;
  };

  void begin_array(TextRange at);
  void end_array(TextRange at);
  void number(double value, TextRange at);
  /// Always throws: only arrays and numbers may stand here.
  [[noreturn]] void other(std::string_view found, TextRange at);
  /// False once the outermost array has ended.
  bool open() const { return depth_ > 0; }

  /// Unknown when there is no number at all.
  Nesting nesting() const { return static_cast<Nesting>(number_depth_); }
  /// The geometry when the numbers are to lie at `nesting`. Throws Complaint when they do not.
  Feature as_points(Nesting nesting) const;
  Feature as_lines(Nesting nesting) const;
  Feature as_polygons(Nesting nesting) const;

 private:
  /// The end of an array that holds arrays, or nothing.
  struct End {
    std::size_t depth, positions, offset;
  };
  static constexpr std::size_t max_depth = 4;

  std::string place(std::size_t depth) const;
  void expect(Nesting nesting) const;
  /// The paths as runs of positions, and after each polygon a mark.
  template <class OnPath, class OnPolygon>
  void for_each(Nesting nesting, OnPath&& on_path, OnPolygon&& on_polygon) const;

  std::vector<Vec3d> positions_;
  std::vector<End> ends_;
  std::array<std::size_t, max_depth + 1> children_{};  // of the arrays that are open, by depth
  std::size_t depth_ = 0, number_depth_ = 0, first_number_ = 0, numbers_ = 0;
  Vec3d position_{};
};

}  // namespace lambert::polygon
