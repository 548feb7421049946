#pragma once
/// Functions of the plane that are hard to sample.

#include "lambert/lab/sampled_image.h"

namespace lambert::lab {

/// White triangles side by side on black, each `pitch` pixels wide at its base and `height` high, the first at x = 0;
/// apexes at y = top (Cook 1986: at 1.01 pixels a regular sample a pixel shows one false tooth of 101 pixels).
struct Comb {
  int teeth = 50;
  double pitch = 1.01, height = 50, top = 0;
};
Scene comb(const Comb& comb);

/// The period in pixels of what samples at pixel centres show of a structure of `period` pixels; infinite when all
/// samples see the same. The frequency is folded below half a sample a pixel (Nyquist).
double alias_period(double period);
/// The frequency that `rate` samples a unit show for one of `frequency`: its distance to the nearest multiple of
/// `rate`.
double alias_frequency(double frequency, double rate);

/// (1 + cos(π r² / width)) / 2 around the middle: the frequency grows with the distance, to half a cycle a pixel at a
/// distance of width / 2 pixels, everything beyond is aliased in regular samples.
Scene zone_plate(int width, int height);

/// A checkerboard to the horizon at a third of the height.
Scene checkered_plane(int width, int height);

/// Parallel dark lines on white: half of `period` wide, turned by `angle` (radians), moved across by `shift` pixels.
struct Lines {
  double period = 6, angle = 0, shift = 0;
};
/// Two layers of lines, dark where either is.
Scene moire(const Lines& a, const Lines& b);

/// Thin and small things on a dark ground: lines of a third of a pixel, dots of half a pixel, a wedge.
Scene small_details(int width, int height);

}  // namespace lambert::lab
