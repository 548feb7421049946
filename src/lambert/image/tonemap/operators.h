#pragma once
/// All operators. Each has a name, a summary, settings() and one of:
///  - curve(map): a function of luminance for the map, of which it has the statistics (and the luminances themselves
///    when it says needs_luminances),
///  - map(map): the display luminances of all pixels, for operators that look at the neighbourhood,
///  - colour_curve(map): a function of colour, for the statistics of the map,
///  - map(planes, map): changes the colours of all pixels.
/// What they make may be outside [0, 1] and is clipped. Luminances are finite and not negative.

#include "lambert/image/tonemap/aces.h"
#include "lambert/image/tonemap/agx.h"
#include "lambert/image/tonemap/darkest.h"
#include "lambert/image/tonemap/drago.h"
#include "lambert/image/tonemap/durand.h"
#include "lambert/image/tonemap/fattal.h"
#include "lambert/image/tonemap/filmic.h"
#include "lambert/image/tonemap/linear.h"
#include "lambert/image/tonemap/mertens.h"
#include "lambert/image/tonemap/ocio.h"
#include "lambert/image/tonemap/photographic_local.h"
#include "lambert/image/tonemap/reinhard.h"
#include "lambert/image/tonemap/reinhard_devlin.h"

#include <concepts>
#include <variant>

namespace lambert {

using ToneOperator =
    std::variant<tone::Linear, tone::DarkestRange, tone::DarkestPixels, tone::Reinhard, tone::Photographic,
                 tone::PhotographicLocal, tone::ReinhardDevlin, tone::Drago, tone::Durand, tone::Fattal, tone::Mertens,
                 tone::Filmic, tone::Aces, tone::Agx, tone::Ocio>;

namespace tone {

template <class T>
concept LuminanceCurve = requires(const T op, const LuminanceMap map, float l) {
  { op.curve(map)(l) } -> std::same_as<float>;
};
template <class T>
concept LuminanceOperator = requires(const T op, const LuminanceMap map) {
  { op.map(map) } -> std::same_as<Plane>;
};
template <class T>
concept ColourCurve = requires(const T op, const LuminanceMap map, Rgb c) {
  { op.colour_curve(map)(c) } -> std::same_as<Rgb>;
};
template <class T>
concept ColourOperator = requires(const T op, const LuminanceMap map, RgbPlanes planes) {
  op.map(planes, map);
};

}  // namespace tone
}  // namespace lambert
