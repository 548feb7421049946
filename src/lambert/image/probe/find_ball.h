#pragma once
#include "lambert/image/image.h"

#include <optional>

namespace lambert::probe {

/// A circle in pixels: pixel (0, 0) begins at (0, 0).
struct BallCircle {
  Vec2d centre{0};
  double radius = 0;
  double coverage = 0;  ///< the part of the circle along which an edge was found, 0 to 1
  double residual = 0;  ///< root mean square distance of these edges from the circle, pixels
};

struct FindBallSettings {
  double smallest = 0.06, largest = 0.75;  ///< radius as a part of the picture's shorter side
  double least_coverage = 0.45;
};

/// Finds the outline of a ball: circles through pairs of edges whose normals meet are tried (in a fixed order), the one
/// with most edge along it is fitted by least squares to edges at the full resolution, outliers left out. Centre and
/// radius are right to about a pixel where the outline has contrast; a ball off the picture's middle looks
/// slightly oval in perspective, of which this is the mean circle. None when no circle has the wanted coverage. Where
/// grey is darker than 0 or not finite it counts as black.
std::optional<BallCircle> find_ball(const Image& image, const FindBallSettings& settings = {});

/// What part of the circle lies in the picture; below 1 the ball is cut by the frame, and a crop has black in it.
double part_in_picture(const Image& image, const BallCircle& circle);

/// The square about the circle, resampled bilinearly so that the circle touches its sides: a mirror-ball layout of
/// `size` pixels (0: twice the radius, rounded). Outside of the picture it is 0.
Image crop_ball(const Image& image, const BallCircle& circle, int size = 0);

/// A mirror's reflectivity: what it shows of a patch over the patch seen directly in the same photograph, both given as
/// windows of pixels and averaged. Throws Error when a window does not lie in the picture or is black.
Rgb ball_reflectivity(const Image& image, const Window& reflected, const Window& direct);

}  // namespace lambert::probe
