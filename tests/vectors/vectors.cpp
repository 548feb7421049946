#include "vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace lambert {

void Vector::expect_near(double actual, const nlohmann::json& value, Precision precision) const {
  const double e = value.get<double>();
  // The file prints twelve digits.
  const double printed = 5e-12 * std::max(1.0, std::abs(e));
  const double stated = std::max({absolute, relative * std::abs(e), absolute > 0 || relative > 0 ? printed : 0.0});
  const double rounding = precision == Precision::in_float ? 1e-6 * std::max(1.0, std::abs(e)) : 0.0;
  EXPECT_NEAR(actual, e, std::max(stated, rounding)) << id;
}

void Vector::expect_near(Vec3d actual, const nlohmann::json& value, Precision precision) const {
  ASSERT_EQ(value.size(), 3u) << id;
  for (int i = 0; i < 3; ++i) expect_near(actual[i], value[static_cast<std::size_t>(i)], precision);
}

void Vector::expect_near(float actual, const nlohmann::json& value) const {
  expect_near(static_cast<double>(actual), value, Precision::in_float);
}
void Vector::expect_near(Vec3 actual, const nlohmann::json& value) const {
  expect_near(Vec3d(actual), value, Precision::in_float);
}

Vec3d vec3d(const nlohmann::json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

const std::vector<Vector>& vectors() {
  static const std::vector<Vector> all = [] {
    std::ifstream file(LAMBERT_SOURCE_DIR "/tests/vectors/vectors.json");
    std::vector<Vector> read;
    const auto parsed = nlohmann::json::parse(file);
    for (const auto& v : parsed.at("vectors"))
      read.push_back({v.at("id"), v.at("input"), v.at("expected"), v.at("tolerance").value("abs", 0.0),
                      v.at("tolerance").value("rel", 0.0)});
    return read;
  }();
  return all;
}

std::map<std::string, Check>& checks() {
  static std::map<std::string, Check> all;
  return all;
}

}  // namespace lambert
