#pragma once
#include "lambert/image/composite/expression.h"

#include <string>

namespace lambert::composite {

/// What is wrong with a number of a parameter: out of range, keys out of order; empty when nothing is.
std::string fault_of(const Number& number, const Parameter& parameter);
/// The parameter of number `i`: those of a word with `more` go on with its last two.
const Parameter& parameter_of(const Word& word, std::size_t i);

}  // namespace lambert::composite
