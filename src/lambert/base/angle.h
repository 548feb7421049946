#pragma once
#include "lambert/base/vec.h"

#include <cmath>

namespace lambert {

/// An angle that knows its unit: `degrees(40)` and `radians(0.7f)` cannot be confused.
class Angle {
 public:
  constexpr Angle() = default;
  constexpr float radians() const { return radians_; }
  constexpr float degrees() const { return radians_ * (180.0f / pi); }
  constexpr auto operator<=>(const Angle&) const = default;
  friend constexpr Angle radians(float r) { return Angle(r); }
  friend constexpr Angle operator*(float s, Angle a) { return Angle(s * a.radians_); }
  friend constexpr Angle operator*(Angle a, float s) { return Angle(s * a.radians_); }
  friend constexpr Angle operator/(Angle a, float s) { return Angle(a.radians_ / s); }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }

 private:
  constexpr explicit Angle(float r) : radians_(r) {}
  float radians_ = 0;
};

constexpr Angle radians(float r);
constexpr Angle degrees(float d) { return radians(d * (pi / 180.0f)); }

inline float sin(Angle a) { return std::sin(a.radians()); }
inline float cos(Angle a) { return std::cos(a.radians()); }
inline float tan(Angle a) { return std::tan(a.radians()); }

}  // namespace lambert
