#include "lambert/formats/pbrt/directives.h"

#include <array>
#include <cmath>

namespace lambert::pbrt {
namespace {

Vec3 expect_vector(Call& c, const char* what) {
  const float x = c.tokens.expect_number(what), y = c.tokens.expect_number(what);
  return {x, y, c.tokens.expect_number(what)};
}

/// 16 numbers, column after column, in brackets or not.
Mat4 expect_matrix(Call& c) {
  const bool in_brackets = c.tokens.peek().kind == TokenKind::open;
  if (in_brackets) c.tokens.next();
  Mat4 m;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) m[column][row] = c.tokens.expect_number("one of the matrix' 16 numbers");
  }
  if (in_brackets) {
    const Token t = c.tokens.next();
    if (t.kind != TokenKind::close)
      c.tokens.fail(t, "expected ']' behind the matrix' 16 numbers, found " + describe(t));
  }
  return m;
}

void rotate(Call& c) {
  const float angle = c.tokens.expect_number("the angle in degrees");
  const Vec3 axis = expect_vector(c, "the axis of the rotation");
  if (!(length_squared(axis) > 0)) c.fail("the axis is zero");
  c.builder.concat_transform(Transform::rotate(degrees(angle), axis));
}

// World to camera, for pbrt's left-handed camera: +x right, +y up, +z forward.
void look_at(Call& c) {
  const Vec3 eye = expect_vector(c, "the eye"), target = expect_vector(c, "the point looked at");
  const Vec3 up = expect_vector(c, "the up vector"), forward = target - eye;
  const Vec3 right = cross(up, forward);
  if (!(length_squared(forward) > 0)) c.fail("the eye is the point looked at");
  if (!(length_squared(right) > 1e-12f * length_squared(up) * length_squared(forward))) {
    c.fail("the up vector is zero or points along the view");
  }
  const Vec3 z = normalize(forward), x = normalize(right), y = cross(z, x);
  c.builder.concat_transform(Transform(Mat4(Vec4(x, 0), Vec4(y, 0), Vec4(z, 0), Vec4(eye, 1))).inverse());
}

void active_transform(Call& c) {
  const Token t = c.tokens.next();
  if (t.text == "All") {
    c.builder.set_active_transforms(true, true);
  } else if (t.text == "StartTime") {
    c.builder.set_active_transforms(true, false);
  } else if (t.text == "EndTime") {
    c.builder.set_active_transforms(false, true);
  } else {
    c.tokens.fail(t, "unknown transformation " + unknown_word(t.text, {"All", "StartTime", "EndTime"}));
  }
}

void translate(Call& c) { c.builder.concat_transform(Transform::translate(expect_vector(c, "the translation"))); }
void scale(Call& c) { c.builder.concat_transform(Transform::scale(expect_vector(c, "the scale"))); }
void transform(Call& c) { c.builder.set_transform(Transform(expect_matrix(c))); }
void concat_transform(Call& c) { c.builder.concat_transform(Transform(expect_matrix(c))); }
void identity(Call& c) { c.builder.set_transform(Transform()); }
void coordinate_system(Call& c) {
  c.builder.define_coordinate_system(c.tokens.expect_string("the name of the coordinate system"));
}
void coord_sys_transform(Call& c) {
  c.builder.use_coordinate_system(c.tokens.expect_string("the name of a coordinate system"), c.place());
}
void transform_times(Call& c) {
  c.tokens.expect_number("the start time");
  c.tokens.expect_number("the end time");
}

constexpr std::array<Directive, 11> directives{{
    {"ActiveTransform", Where::anywhere, active_transform},
    {"ConcatTransform", Where::anywhere, concat_transform},
    {"CoordSysTransform", Where::anywhere, coord_sys_transform},
    {"CoordinateSystem", Where::anywhere, coordinate_system},
    {"Identity", Where::anywhere, identity},
    {"LookAt", Where::anywhere, look_at},
    {"Rotate", Where::anywhere, rotate},
    {"Scale", Where::anywhere, scale},
    {"Transform", Where::anywhere, transform},
    {"TransformTimes", Where::before_world, transform_times},
    {"Translate", Where::anywhere, translate},
}};

}  // namespace

std::span<const Directive> transform_directives() { return directives; }

}  // namespace lambert::pbrt
