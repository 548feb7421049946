#include "vectors.h"

#include "lambert/image/composite/adjust.h"
#include "lambert/image/composite/porter_duff.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

using namespace composite;

Pixel pixel_of(const nlohmann::json& v) {
  return {v.at(0).get<float>(), v.at(1).get<float>(), v.at(2).get<float>(), v.at(3).get<float>()};
}
void expect_pixel(const Vector& v, Pixel p, const nlohmann::json& expected) {
  v.expect_near(p.r, expected.at(0));
  v.expect_near(p.g, expected.at(1));
  v.expect_near(p.b, expected.at(2));
  v.expect_near(p.a, expected.at(3));
}

// rows: AA-27
const CheckOf stored("V-AA-14", [](const Vector& v) {
  const auto& c = v.input.at("color");
  const Pixel straight{c.at(0).get<float>(), c.at(1).get<float>(), c.at(2).get<float>(),
                       v.input.at("coverage").get<float>()};
  expect_pixel(v, premultiply(straight), v.expected.at("stored"));
  EXPECT_EQ(unpremultiply(premultiply(straight)), straight);
  expect_pixel(v, clear_pixel, v.expected.at("clear"));
  expect_pixel(v, black_pixel, v.expected.at("black"));
});

// rows: AA-28 AA-30
const CheckOf areas("V-AA-15", [](const Vector& v) {
  const CoverageAreas a = coverage_areas(v.input.at("aA").get<float>(), v.input.at("aB").get<float>());
  v.expect_near(a.a_only, v.expected.at("A_only"));
  v.expect_near(a.b_only, v.expected.at("B_only"));
  v.expect_near(a.neither, v.expected.at("none"));
  v.expect_near(a.both, v.expected.at("both"));
});

// rows: AA-29 AA-30
const CheckOf operators("V-AA-16", [](const Vector& v) {
  using enum Operator;
  const std::map<std::string, Operator> named = {{"clear", clear}, {"A", a},     {"B", b},       {"over", over},
                                                 {"in", in},       {"out", out}, {"atop", atop}, {"xor", exclusive_or}};
  EXPECT_EQ(v.expected.size(), named.size());
  for (const auto& [name, op] : named)
    expect_pixel(v, combine(op, pixel_of(v.input.at("A")), pixel_of(v.input.at("B"))), v.expected.at(name));
});

}  // namespace
}  // namespace lambert
