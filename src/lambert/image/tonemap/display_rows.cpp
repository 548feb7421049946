#include "lambert/image/tonemap/display_rows.h"

#include "lambert/image/tonemap/fast_math.h"

namespace lambert::tone {
namespace {

float displayable(float v) {
  const float positive = v > 0 ? v : 0.0f;
  return positive < 1 ? positive : 1.0f;
}

template <std::size_t stride>
void store_colours(const ColourRow& row, float* to) {
  const float* const r = row.r.data();
  const float* const g = row.g.data();
  const float* const b = row.b.data();
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x) {
    to[x * stride] = displayable(r[x]);
    to[x * stride + 1] = displayable(g[x]);
    to[x * stride + 2] = displayable(b[x]);
  }
}

}  // namespace

std::vector<std::string> display_channels(const Image& image) {
  std::vector<std::string> channels = image.has_colour() ? rgb_channels() : std::vector<std::string>{"Y"};
  if (image.channel("A")) channels.emplace_back("A");
  return channels;
}

Image empty_display(const Image& image) {
  Image out(image.width(), image.height(), display_channels(image));
  out.place({image.data_window().x, image.data_window().y}, image.display_window());
  out.metadata = image.metadata;
  return out;
}

void store(const ColourRow& row, bool alpha, Image& out, int y) {
  float* const to = out.row(y).data();
  const std::size_t n = out.channel_count(), colours = alpha ? n - 1 : n;
  if (colours == 3 && n == 3)
    store_colours<3>(row, to);
  else if (colours == 3)
    store_colours<4>(row, to);
  else
    for (std::size_t x = 0; x < row.g.size(); ++x) to[x * n] = displayable(row.g[x]);
  if (!alpha) return;
  for (std::size_t x = 0; x < row.alpha.size(); ++x) {
    const float a = row.alpha[x];
    for (std::size_t c = 0; a > 0 && c < colours; ++c) to[x * n + c] *= a;
    to[x * n + colours] = a;
  }
}

void colour_from_luminance(ColourRow& row, const float* light, const float* shown, float* ratio, float saturation) {
  const std::size_t width = row.r.size();
  for (std::size_t x = 0; x < width; ++x)
    ratio[x] = (saturation == 1 ? shown[x] : 1.0f) / at_least(light[x], least_luminance);
  for (std::vector<float>* channel : {&row.r, &row.g, &row.b}) {
    float* const c = channel->data();
    if (saturation == 1) {
      for (std::size_t x = 0; x < width; ++x) c[x] = chosen(light[x] > least_luminance, c[x] * ratio[x], shown[x]);
    } else {
      for (std::size_t x = 0; x < width; ++x) {
        const float share = at_least(c[x] * ratio[x], 1e-30f);
        c[x] = chosen(light[x] > least_luminance, fast_pow(share, saturation) * shown[x], shown[x]);
      }
    }
  }
}

}  // namespace lambert::tone
