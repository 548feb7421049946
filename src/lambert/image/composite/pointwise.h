#pragma once
#include "lambert/image/composite/elements.h"
#include "lambert/image/composite/language.h"

#include <string>
#include <vector>

namespace lambert::composite {

/// minus, difference, max, min, multiply, screen: of R, G, B and A, channel by channel; extra channels stay those of A.
ElementPtr arithmetic(Verb verb, ElementPtr a, ElementPtr b);

/// White where the element is: its alpha, or the luminance of what has none.
ElementPtr matte_of(ElementPtr input);

/// The words that change pixels one by one. `numbers` are those of the word; `second` is for key-difference. Throws
/// Error for a channel that is missing and for keys that make no sense.
ElementPtr pointwise(Verb verb, const std::vector<float>& numbers, const std::string& text, ElementPtr input,
                     ElementPtr second);

}  // namespace lambert::composite
