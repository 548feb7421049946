#pragma once
/// What `lambert compare` finds out, and what it says of it.

#include "lambert/image/compare/errors.h"
#include "lambert/image/compare/flip.h"
#include "lambert/image/compare/ssim.h"
#include "lambert/image/compare/z_scores.h"

#include <cmath>
#include <optional>
#include <string>

namespace lambert::cli {

struct Thresholds {
  double each = 1e-6;  ///< of a pixel's largest channel, or of the metric
  double percent = 0;  ///< of the pixels that may pass it
  double hard = HUGE_VAL;
};

struct CompareOptions {
  std::string image, reference;
  Thresholds fail, warn;
  std::string metric, space = "auto", heat, heat_of = "error", difference;
  double heat_top = 0, alpha = 0.01;
  compare::FlipSettings flip;
  bool layers = false, z = false, json = false, quiet = false;
};

/// Two images of the same size: the colour channels, and A where both images have it; with `layers` all channels, which
/// must then be the same.
struct Pair {
  Image a, b;
  bool radiance = true;  ///< linear light without bounds; else sRGB codes over their largest
};

/// What a metric says, and whether more of it is better.
struct Score {
  double value = 0;
  bool higher_is_better = false;
};

struct Comparison {
  const CompareOptions& o;
  Image linear_a, linear_b;  ///< with all their channels
  Pair pair;
  compare::Errors errors;
  std::optional<compare::Similarity> similarity;
  std::optional<compare::Flip> flip;
  std::optional<compare::ZTest> z;

  double peak() const;
  /// By --metric, which must name one.
  Score score() const;
};

/// All channels of both files, unconverted. Throws Error when one cannot be read.
Pair read_pair(const CompareOptions& o);
/// Throws Error when the images cannot be compared so.
Comparison compared(const CompareOptions& o, Pair pair);

/// The exit statuses, as of idiff.
inline constexpr int same = 0, warned = 1, different = 2, sizes_differ = 3;
int verdict(const Comparison& c);

/// Throws Error, before any work, when a file that was asked for could not be written.
void check_pictures(const CompareOptions& o);
/// The files that were asked for.
void write_pictures(const Comparison& c);
void print_report(const Comparison& c, int status);

}  // namespace lambert::cli
