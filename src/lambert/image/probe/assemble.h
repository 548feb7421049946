#pragma once
#include "lambert/base/angle.h"
#include "lambert/image/probe/layout.h"

#include <vector>

namespace lambert::probe {

/// One photograph of the ball, cropped to it: a Probe of MirrorBall projection, and where its camera stood: at
/// `azimuth` about +y from +z (90 degrees: at +x), looking at the ball horizontally.
struct BallView {
  Probe ball;
  Angle azimuth;
};

struct AssembleSettings {
  Angle camera_radius = degrees(25);  ///< about the ball's centre, what shows camera and photographer: not used
  Angle rim = degrees(150);           ///< from here on to the rim the ball is too smeared: not used if others see it
  Angle feather = degrees(15);        ///< over which weights rise
  bool align = true;                  ///< refine each view's rotation (all but the first's) by correlation
  Angle search = degrees(8);          ///< how far it may be off about each axis
  bool match_exposure = true;         ///< scale all views but the first to it, per channel
};

struct Assembly {
  Probe probe;                      ///< lat-long, in the frame of the first camera: it stands at +z
  std::vector<Mat3> rotations;      ///< from each ball's frame to it
  std::vector<Rgb> exposures;       ///< what each view was multiplied by
  std::vector<float> correlations;  ///< of log luminance with the views before it; 1 for the first
};

/// Blends views of a mirror ball from at least two directions into one map `rows` high, so that camera and photographer
/// vanish: each direction is taken from the views that see it well. Weights are w_centre w_rim cos²(θ/2), θ the angle
/// to the camera: the square of how many texels of the ball's radius an angle gets. Where no view is good the least bad
/// is taken. Throws Error for fewer than two views, other projections or different channels. Values must be finite.
Assembly assemble(const std::vector<BallView>& views, int rows, const AssembleSettings& settings = {});

}  // namespace lambert::probe
