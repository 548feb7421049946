#pragma once
namespace lambert {

/// As many threads as Imf should work with; the first call makes its pool.
int exr_threads();

}  // namespace lambert
