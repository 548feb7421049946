#include "lambert/image/composite/check_numbers.h"

#include "lambert/base/number.h"

namespace lambert::composite {

std::string fault_of(const Number& number, const Parameter& parameter) {
  const auto out_of_range = [&](double value) { return !(value >= parameter.low && value <= parameter.high); };
  const auto complaint = [&](double value) {
    return "expected " + std::string(parameter.name) + " from " + number_text(parameter.low) + " to " +
           number_text(parameter.high) + ", found " + number_text(value);
  };
  if (number.keys.empty()) return out_of_range(number.value) ? complaint(number.value) : "";
  for (std::size_t i = 0; i < number.keys.size(); ++i) {
    if (out_of_range(number.keys[i].value)) return complaint(number.keys[i].value);
    if (i > 0 && !(number.keys[i].frame > number.keys[i - 1].frame))
      return "expected a frame after " + number_text(number.keys[i - 1].frame) + ", found " +
             number_text(number.keys[i].frame);
  }
  return {};
}

const Parameter& parameter_of(const Word& word, std::size_t i) {
  const std::size_t count = word.parameters.size();
  return word.parameters[i < count ? i : count - 2 + (i - count) % 2];
}

}  // namespace lambert::composite
