#include "lambert/formats/pbrt/image_textures.h"

#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/image/colour.h"
#include "lambert/image/io.h"

#include <algorithm>
#include <cmath>

namespace lambert::pbrt {
namespace {

/// How stored numbers become linear light.
struct Encoding {
  bool srgb = false;
  float gamma = 1;  ///< used when not srgb
  std::string key() const { return srgb ? "sRGB" : std::to_string(gamma); }
};

Encoding parse_encoding(const ParameterList& list, const std::string& filename) {
  const bool is_linear = at_directive(list, [&] { return is_radiance_format(filename); });
  const std::string word = list.string("encoding", is_linear ? "linear" : "sRGB");
  if (word == "sRGB") return {true, 1};
  if (word == "linear") return {false, 1};
  constexpr std::string_view prefix = "gamma ";
  float gamma = 0;
  const char* last = word.data() + word.size();
  if (word.starts_with(prefix) && parse_float(word.data() + prefix.size(), last, gamma) == last && gamma > 0) {
    return {false, gamma};
  }
  list.fail("unknown encoding " + unknown_word(word, {"sRGB", "linear", "gamma <exponent>"}));
}

EdgeMode parse_wrap(const ParameterList& list) {
  const std::string word = list.string("wrap", "repeat");
  if (word == "repeat") return EdgeMode::repeat;
  if (word == "clamp") return EdgeMode::clamp;
  if (word == "black") return EdgeMode::black;
  if (word == "mirror") return EdgeMode::mirror;
  list.fail("unknown wrap mode " + unknown_word(word, {"repeat", "clamp", "black", "mirror"}));
}

TextureFilter parse_filter(const Context& context, const ParameterList& list) {
  const std::string word = list.string("filter", "bilinear");
  if (word == "point") return TextureFilter::nearest;
  if (word == "bilinear") return TextureFilter::bilinear;
  if (word == "trilinear") return TextureFilter::trilinear;
  if (word != "ewa" && word != "EWA") {
    list.fail("unknown texture filter " + unknown_word(word, {"point", "bilinear", "trilinear", "ewa"}));
  }
  context.notes.add("texture filter 'ewa' is done as 'trilinear'");
  list.number("maxanisotropy", 8);
  return TextureFilter::trilinear;
}

/// Floats that are not linear light become so; 8-bit sRGB is left to the mip map.
void linearise(Texels& t, const Encoding& encoding, bool already_linear) {
  if (already_linear) return;
  const auto decode = [&](float v) {
    return encoding.srgb ? srgb_decode(v) : std::pow(std::max(v, 0.0f), encoding.gamma);
  };
  if (!t.bytes.empty() && !encoding.srgb && encoding.gamma != 1) {
    t.floats.resize(t.bytes.size());
    std::transform(t.bytes.begin(), t.bytes.end(), t.floats.begin(),
                   [](std::uint8_t b) { return static_cast<float>(b) / 255; });
    t.bytes.clear();
  }
  if (encoding.srgb || encoding.gamma != 1) {
    for (std::size_t i = 0; i < t.floats.size(); ++i) {
      const bool is_alpha =
          t.channels % 2 == 0 && i % static_cast<std::size_t>(t.channels) + 1 == static_cast<std::size_t>(t.channels);
      if (!is_alpha) t.floats[i] = decode(t.floats[i]);
    }
  }
}

template <class T>
std::vector<T> single_channel(const std::vector<T>& values, std::size_t channels, T opaque, bool& took_alpha) {
  const std::size_t pixels = values.size() / channels;
  const std::size_t colours = channels % 2 == 0 ? channels - 1 : channels;
  bool has_alpha = false;
  for (std::size_t i = 0; i < pixels && colours < channels; ++i) {
    has_alpha = has_alpha || values[i * channels + colours] != opaque;
  }
  std::vector<T> single(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const T* pixel = &values[i * channels];
    float sum = 0;
    for (std::size_t c = 0; c < colours; ++c) sum += static_cast<float>(pixel[c]);
    single[i] = has_alpha ? pixel[colours] : static_cast<T>(sum / static_cast<float>(colours));
  }
  took_alpha = took_alpha || has_alpha;
  return single;
}

/// True when the channel that is left is alpha, which is never encoded.
bool reduce_to_single(Texels& t) {
  bool took_alpha = false;
  const auto channels = static_cast<std::size_t>(t.channels);
  if (channels == 1) return false;
  if (!t.bytes.empty()) t.bytes = single_channel<std::uint8_t>(t.bytes, channels, 255, took_alpha);
  if (!t.floats.empty()) t.floats = single_channel<float>(t.floats, channels, 1, took_alpha);
  t.channels = 1;
  return took_alpha;
}

std::shared_ptr<const MipMap> load(Context& context, const std::string& filename, const Encoding& encoding,
                                   MipMap::Settings settings, bool single) {
  const std::filesystem::path path = context.resolve(filename);
  const std::string key = path.string() + "|" + encoding.key() + "|" +
                          std::to_string(static_cast<int>(settings.filter)) +
                          std::to_string(static_cast<int>(settings.wrap_u)) + (single ? "1" : "3");
  std::shared_ptr<const MipMap>& image = context.images[key];
  if (image) return image;
  const MappedFile file(path);
  Texels texels = decode_texels(file.bytes(), path.string());
  const bool is_alpha = single && reduce_to_single(texels);
  if (!is_alpha) linearise(texels, encoding, is_radiance_format(path) && encoding.key() == Encoding().key());
  settings.srgb = encoding.srgb && !is_alpha && !texels.bytes.empty();
  image = std::make_shared<const MipMap>(std::move(texels), settings);
  return image;
}

}  // namespace

UvTransform uv_mapping(const ParameterList& list, bool flip) {
  const std::string kind = list.string("mapping", "uv");
  if (kind != "uv") list.fail("unknown texture mapping " + unknown_word(kind, {"uv"}));
  const float su = list.number("uscale", 1), sv = list.number("vscale", 1);
  const float du = list.number("udelta", 0), dv = list.number("vdelta", 0);
  UvTransform t;
  t.matrix = flip ? glm::mat3x2(su, 0, 0, -sv, du, 1 - dv) : glm::mat3x2(su, 0, 0, sv, du, dv);
  return t;
}

ImageTexture image_texture(Context& context, const ParameterList& list, bool single) {
  const std::string filename = list.string("filename", "");
  if (filename.empty()) list.fail("has no \"string filename\"");
  MipMap::Settings settings;
  settings.filter = parse_filter(context, list);
  settings.wrap_u = settings.wrap_v = parse_wrap(list);
  const Encoding encoding = parse_encoding(list, filename);
  ImageTexture texture;
  texture.image = at_directive(list, [&] { return load(context, filename, encoding, settings, single); });
  texture.uv = uv_mapping(list, true);
  const float scale = list.number("scale", 1);
  texture.scale = Texel(scale, scale, scale, 1);
  texture.invert = list.boolean("invert", false);
  if (texture.invert && scale != 1) {
    context.notes.add("'invert' of an imagemap comes before its 'scale', not behind");
  }
  return texture;
}

TextureId add_plain_image(Context& context, const ParameterList& list, const std::string& filename) {
  const Encoding encoding = parse_encoding(list, filename);
  ImageTexture texture;
  texture.image = at_directive(list, [&] { return load(context, filename, encoding, {}, false); });
  texture.uv.matrix = {1, 0, 0, -1, 0, 1};
  return context.graph.textures.add(texture);
}

TextureId add_normal_map(Context& context, const ParameterList& list, const std::string& filename) {
  ImageTexture texture;
  texture.image = at_directive(list, [&] { return load(context, filename, {}, {}, false); });
  texture.uv.matrix = {1, 0, 0, -1, 0, 1};
  return context.graph.textures.add(texture);
}

}  // namespace lambert::pbrt
