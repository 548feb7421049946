#pragma once
/// Mattes out of colour. All of it works on linear Rec. 709 light, in which the light of a pixel's parts adds up: a
/// pixel that a subject F covers by alpha before a backing K has the colour C = alpha F + (1 - alpha) K, so that
/// C - (1 - alpha) K is the subject, premultiplied.

#include "lambert/base/rgb.h"
#include "lambert/image/composite/porter_duff.h"

namespace lambert::composite {

/// `rgb` with the spill of the backing held back: the channel in which `key` is largest is limited to the larger of
/// the other two, by `amount` in [0, 1].
Rgb suppress_spill(Rgb rgb, Rgb key, float amount);

/// By distance of hue: colour differences (R - Y, B - Y), Y the Rec. 709 luminance, in proportion to those of the key.
/// They are linear in C: for a grey subject the distance is the coverage itself.
struct ColourKey {
  Rgb colour;          ///< of the backing; not grey
  float inner = 0.1f;  ///< distances up to it are backing
  float outer = 1;     ///< distances from it on are subject; between them the matte is linear
  float spill = 1;     ///< suppression, 0 to 1
};
/// Throws Error when the key is grey or not finite, or inner and outer are not 0 <= inner < outer.
void check(const ColourKey& key);
float matte(const ColourKey& key, Rgb c);
/// The subject before the backing that `p` shows; its alpha is multiplied by the matte.
Pixel apply(const ColourKey& key, Pixel p);

/// By colour difference (Vlahos): how much the channel in which the backing is largest exceeds the other two, in
/// proportion to that of the backing itself. Subjects of any colour in which that channel is not the largest stay
/// whole, and shadows on the backing are kept as coverage.
struct ScreenKey {
  Rgb colour;       ///< of the backing; one channel must exceed the others
  float low = 0;    ///< a matte up to it becomes 0
  float high = 1;   ///< and from it on 1
  float spill = 1;  ///< suppression, 0 to 1
};
void check(const ScreenKey& key);
float matte(const ScreenKey& key, Rgb c);
Pixel apply(const ScreenKey& key, Pixel p);

/// By difference from a clean plate: the largest of the channels' absolute differences.
struct DifferenceKey {
  float low = 0.02f, high = 0.1f;  ///< differences up to low are backing, from high on subject
};
void check(const DifferenceKey& key);
float matte(const DifferenceKey& key, Rgb c, Rgb clean);
Pixel apply(const DifferenceKey& key, Pixel p, Pixel clean);

}  // namespace lambert::composite
