#pragma once
/// The worked examples of vectors.json. A check is registered by a constant of namespace scope; every example of the
/// file must have one, and every check its example (vectors_test.cpp).

#include "lambert/base/vec.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace lambert {

/// What computed it: double is held to the tolerance of the file, float to its own rounding, 1e-6 of the larger of 1
/// and the value, if that is more.
enum class Precision { in_double, in_float };

struct Vector {
  std::string id;
  nlohmann::json input, expected;
  double absolute = 0, relative = 0;  ///< tolerance

  void expect_near(double actual, const nlohmann::json& value, Precision precision = Precision::in_double) const;
  void expect_near(Vec3d actual, const nlohmann::json& value, Precision precision = Precision::in_double) const;
  void expect_near(float actual, const nlohmann::json& value) const;
  void expect_near(Vec3 actual, const nlohmann::json& value) const;
};

Vec3d vec3d(const nlohmann::json& value);
inline Vec3 vec3(const nlohmann::json& value) { return Vec3(vec3d(value)); }

/// All of the file, in its order.
const std::vector<Vector>& vectors();

using Check = std::function<void(const Vector&)>;
std::map<std::string, Check>& checks();

struct CheckOf {
  CheckOf(const std::string& id, Check check) { checks()[id] = std::move(check); }
};

}  // namespace lambert
