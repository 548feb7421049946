#include "comparison.h"

#include "lambert/base/error.h"
#include "lambert/image/colour.h"
#include "lambert/image/io.h"

#include <algorithm>

namespace lambert::cli {

using namespace compare;

namespace {

Image chosen(const Image& image, bool alpha, bool colour) {
  Image out(image.width(), image.height(),
            colour ? (alpha ? rgba_channels() : rgb_channels()) : std::vector<std::string>{image.channels()[0]});
  const auto a = image.channel("A");
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (colour) {
        out.set_rgb(x, y, image.rgb(x, y));
      } else {
        out.at(x, y, 0) = image.at(x, y, 0);
      }
      if (alpha && colour) out.at(x, y, 3) = image.at(x, y, *a);
    }
  return out;
}

void encode(Image& image) {
  const auto alpha = image.channel("A");
  const std::size_t channels = image.channel_count();
  const auto pixels = image.pixels();
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (!alpha || i % channels != *alpha) pixels[i] = srgb_encode(pixels[i]);
}

void choose_channels(const CompareOptions& o, Pair& pair) {
  if (o.layers) {
    if (pair.a.channels() != pair.b.channels())
      throw Error("the channels differ; without --layers the colours are compared");
  } else {
    const bool alpha = pair.a.channel("A") && pair.b.channel("A");
    const bool colour = pair.a.has_colour() || pair.b.has_colour() || alpha;
    pair.a = chosen(pair.a, alpha, colour);
    pair.b = chosen(pair.b, alpha, colour);
  }
  if (!pair.radiance) encode(pair.a), encode(pair.b);
}

/// Luminance through L / (1 + L), the reference's geometric mean at 0.18, and the sRGB curve: what SSIM, which is made
/// for [0, 1], can judge of radiance.
void compress(Image& a, Image& b) {
  double sum = 0, count = 0;
  for (int y = 0; y < b.height(); ++y)
    for (int x = 0; x < b.width(); ++x)
      if (const double l = static_cast<double>(luminance(b.rgb(x, y))); l > 0 && std::isfinite(l)) {
        sum += std::log(l);
        ++count;
      }
  const auto scale = static_cast<float>(count > 0 ? 0.18 / std::exp(sum / count) : 1.0);
  for (Image* image : {&a, &b}) {
    Image shown(image->width(), image->height(), rgb_channels());
    for (int y = 0; y < image->height(); ++y)
      for (int x = 0; x < image->width(); ++x) {
        const float l = std::max(0.0f, luminance(image->rgb(x, y)) * scale);
        shown.set_rgb(x, y, Rgb(srgb_encode(std::isinf(l) ? 1.0f : l / (1 + l))));
      }
    *image = std::move(shown);
  }
}

bool passes(const Thresholds& t, const Comparison& c) {
  if (!c.o.metric.empty() && c.o.metric != "all") {
    const Score s = c.score();
    return s.higher_is_better ? s.value >= t.each : s.value <= t.each;
  }
  const double share =
      100.0 * static_cast<double>(c.errors.pixels_over(t.each)) / static_cast<double>(c.errors.pixels.size());
  return share <= t.percent && c.errors.largest <= t.hard;
}

}  // namespace

Pair read_pair(const CompareOptions& o) {
  Pair pair{read_image(o.image), read_image(o.reference)};
  const bool shown = !is_radiance_file(o.image) && !is_radiance_file(o.reference);
  pair.radiance = o.space == "linear" || (o.space == "auto" && !shown);
  return pair;
}

double Comparison::peak() const { return pair.radiance ? std::max(errors.largest_value, 1e-30) : 1.0; }
Score Comparison::score() const {
  if (o.metric == "mse") return {errors.mse};
  if (o.metric == "rel-mse") return {errors.relative_mse};
  if (o.metric == "psnr") return {errors.psnr(peak()), true};
  if (o.metric == "ssim") return {similarity->mean, true};
  return {flip->mean};
}

Comparison compared(const CompareOptions& o, Pair pair) {
  Comparison c{.o = o, .linear_a = pair.a, .linear_b = pair.b, .pair = std::move(pair)};
  choose_channels(o, c.pair);
  c.errors = errors_of(c.pair.a, c.pair.b);
  const auto needs = [&](const char* name) {
    return o.metric == name || o.metric == "all" || (!o.heat.empty() && o.heat_of == name);
  };
  if (needs("ssim")) {
    Image a = c.pair.a, b = c.pair.b;
    if (c.pair.radiance) compress(a, b);
    c.similarity = ssim(a, b);
  }
  if (needs("flip"))
    c.flip = c.pair.radiance ? hdr_flip(c.linear_a, c.linear_b, o.flip) : flip(c.linear_a, c.linear_b, o.flip);
  if (o.z || (!o.heat.empty() && o.heat_of == "z")) c.z = z_test(c.linear_a, c.linear_b);
  return c;
}

int verdict(const Comparison& c) {
  if (c.o.z) return c.z->same(c.o.alpha) ? same : different;
  if (!passes(c.o.fail, c)) return different;
  return passes(c.o.warn, c) ? same : warned;
}

}  // namespace lambert::cli
