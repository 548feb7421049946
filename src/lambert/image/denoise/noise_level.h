#pragma once
#include "lambert/image/denoise/noisy_image.h"

namespace lambert::denoise {

/// Replaces variances that are not finite by what the picture itself shows: |L * picture| for the mask L = (1 -2 1)ᵀ(1
/// -2 1), which no plane passes (Immerkær, "Fast Noise Variance Estimation", 1996), is 6 σ times a normal number; σ is
/// told by its median over 17x17 pixels. A texture counts as noise where it fills half of them. What is below zero
/// becomes zero.
void fill_unknown_variance(NoisyImage& image);

/// Scales the variances of samples, which well-distributed samples make too large, to what the difference of measured
/// halves shows: by the mean over 5x5 pixels of their ratios (a - b)² / 4 to the variance, each at most 4; by at most 1
/// (after Rousselle, Knaus and Zwicker 2012, section 5, who take the ratio of the means: there a single outlier that
/// happens to be in both halves hides the noise of all 25 pixels).
void fit_variance_to_halves(NoisyImage& image);

/// Makes halves of a picture that is in both of them (see gather()). The numbers added depend on the pixel alone.
void split(NoisyImage& image);

}  // namespace lambert::denoise
