#pragma once
#include "lambert/lab/demo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lambert::lab {

inline double fact(const Shown& shown, const std::string& name) {
  for (const auto& [known, value] : shown.facts)
    if (known == name) return value;
  ADD_FAILURE() << "no fact '" << name << "'";
  return NAN;
}

}  // namespace lambert::lab
