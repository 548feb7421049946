#pragma once

namespace lambert {

/// Russian roulette (Arvo and Kirk 1990; row PT-26): the factor of a contribution that survives with probability
/// `survival`, 1 / survival when u < survival and 0 when it is absorbed. Its expected value is 1.
inline float russian_roulette(float survival, float u) { return u < survival ? 1 / survival : 0; }

}  // namespace lambert
