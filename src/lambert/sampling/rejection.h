#pragma once
/// Sampling by rejection (row PT-16; von Neumann 1951): X is proposed with density p and accepted with probability
/// f(X) / (c p(X)), where c >= f / p everywhere. What is accepted has density f / ∫f, however many tries it took. On
/// average it takes c ∫p / ∫f of them, so a warp or a table is nearly always better; and a number of tries that varies
/// spoils the stratification of a low-discrepancy sampler: feed it from hashed random numbers.

#include "lambert/base/vec.h"

#include <optional>
#include <type_traits>

namespace lambert {

template <class T>
struct Accepted {
  T value{};
  int tries = 1;
};

/// `propose()` draws X, `acceptance(X)` is f(X) / (c p(X)) in [0,1], and `next()` a random number in [0,1). Nothing
/// when `max_tries` proposals were all rejected.
template <class Propose, class Acceptance, class Next>
auto sample_by_rejection(Propose&& propose, Acceptance&& acceptance, Next&& next, int max_tries = 1000)
    -> std::optional<Accepted<std::decay_t<decltype(propose())>>> {
  for (int tries = 1; tries <= max_tries; ++tries) {
    const auto x = propose();
    if (next() < acceptance(x)) return Accepted<std::decay_t<decltype(propose())>>{x, tries};
  }
  return std::nullopt;
}

/// The unit disk out of the square around it: π/4 of the proposals are accepted.
template <class Next>
std::optional<Accepted<Vec2>> disk_by_rejection(Next&& next, int max_tries = 1000) {
  const auto propose = [&] {
    const float x = 2 * next() - 1;
    return Vec2(x, 2 * next() - 1);
  };
  // The ratio is 0 or 1: no number is needed to decide.
  return sample_by_rejection(
      propose, [](Vec2 p) { return dot(p, p) < 1 ? 1.0f : 0.0f; }, [] { return 0.0f; }, max_tries);
}

}  // namespace lambert
