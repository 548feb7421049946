#include "lambert/polygon/formats/coordinates.h"

#include "lambert/base/number.h"
#include "lambert/polygon/formats/path_builder.h"

#include <span>

namespace lambert::polygon {

std::string Coordinates::place(std::size_t depth) const {
  static constexpr const char* names[] = {"vertex", "ring", "polygon"};
  const std::size_t innermost = number_depth_ == 0 ? depth : number_depth_;
  std::string words;
  for (std::size_t level = 1; level < innermost && level <= depth; ++level)
    words += std::string(names[innermost - 1 - level]) + " " + std::to_string(children_[level]) +
             (level + 1 < innermost && level < depth ? ", " : ": ");
  return words;
}

void Coordinates::begin_array(TextRange at) {
  if (numbers_ > 0 || depth_ == max_depth || (depth_ > 0 && depth_ == number_depth_)) {
    const std::string found = depth_ == max_depth && number_depth_ == 0 ? "arrays nested too deep" : "an array";
    throw Complaint{place(depth_) + "expected a number, found " + found, at.begin};
  }
  ++depth_;
  children_[depth_] = 0;
}

void Coordinates::number(double value, TextRange at) {
  if (number_depth_ == 0) {
    number_depth_ = depth_;
    first_number_ = at.begin;
  } else if (depth_ != number_depth_) {
    throw Complaint{place(depth_) + "expected an array such as [x, y], found a number", at.begin};
  }
  if (numbers_ == 0) position_.z = no_height;
  if (numbers_ < 3) position_[static_cast<int>(numbers_)] = value;
  ++numbers_;
}

void Coordinates::end_array(TextRange at) {
  if (depth_ == number_depth_) {
    if (numbers_ < 2)
      throw Complaint{place(depth_) + "expected two or three numbers, found " + std::to_string(numbers_), at.begin};
    positions_.push_back(position_);
    numbers_ = 0;
  } else {
    ends_.push_back({depth_, positions_.size(), at.begin});
  }
  --depth_;
  ++children_[depth_];
}

void Coordinates::other(std::string_view found, TextRange at) {
  throw Complaint{place(depth_) + "expected a number, found '" + printable(found) + "'", at.begin};
}

void Coordinates::expect(Nesting nesting) const {
  const auto depth = static_cast<std::size_t>(nesting);
  if (number_depth_ != 0 && number_depth_ != depth)
    throw Complaint{"expected numbers " + std::to_string(depth) + " brackets deep, found them " +
                        std::to_string(number_depth_) + " deep",
                    first_number_};
  for (const End& end : ends_)
    if (end.depth > depth || (end.depth == depth && depth > 1))
      throw Complaint{"expected two or three numbers, found an empty array", end.offset};
}

template <class OnPath, class OnPolygon>
void Coordinates::for_each(Nesting nesting, OnPath&& on_path, OnPolygon&& on_polygon) const {
  expect(nesting);
  const std::span<const Vec3d> all(positions_);
  const std::size_t path_depth = nesting == Nesting::position ? 0 : static_cast<std::size_t>(nesting) - 1;
  std::size_t first = 0;
  for (const End& end : ends_) {
    if (end.depth == path_depth) {
      on_path(all.subspan(first, end.positions - first));
      first = end.positions;
    } else if (end.depth + 1 == path_depth) {
      on_polygon();
    }
  }
  if (nesting == Nesting::position && !all.empty()) on_path(all);
}

Feature Coordinates::as_points(Nesting nesting) const {
  Feature feature;
  for_each(
      nesting, [&](auto positions) { feature.points = make_path(positions); }, [] {});
  return feature;
}

Feature Coordinates::as_lines(Nesting nesting) const {
  Feature feature;
  for_each(
      nesting, [&](auto positions) { feature.lines.push_back(make_path(positions)); }, [] {});
  return feature;
}

Feature Coordinates::as_polygons(Nesting nesting) const {
  Feature feature;
  PathPolygon rings;
  const auto finish = [&] {
    if (!rings.empty()) feature.polygons.push_back(std::move(rings));
    rings.clear();
  };
  for_each(
      nesting, [&](auto positions) { rings.push_back(make_closed_ring(positions)); }, finish);
  finish();
  return feature;
}

}  // namespace lambert::polygon
