#pragma once
#include "lambert/image/io.h"

namespace lambert {

/// Turned and mirrored from how a file stores it to how it is seen. `orientation` is TIFF's and Exif's tag 274, 1 to 8;
/// any other number is 1.
Texels oriented(Texels t, int orientation);

}  // namespace lambert
