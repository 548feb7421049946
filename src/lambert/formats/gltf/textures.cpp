#include "lambert/formats/gltf/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lambert::gltf {
namespace {

EdgeMode wrap_of(const JsonView& json) {
  switch (json.count(10497)) {
    case 10497: return EdgeMode::repeat;
    case 33071: return EdgeMode::clamp;
    case 33648: return EdgeMode::mirror;
    default: json.fail("unknown wrap mode (known: 10497, 33071, 33648)");
  }
}

/// The magnification filter decides on "nearest", the minification filter on mip maps.
TextureFilter filter_of(const JsonView& sampler) {
  const std::size_t magnify = sampler["magFilter"].count(9729), minify = sampler["minFilter"].count(9987);
  if (magnify == 9728) return TextureFilter::nearest;
  return minify == 9728 || minify == 9729 ? TextureFilter::bilinear : TextureFilter::trilinear;
}

bool is_ktx2(std::span<const std::byte> bytes) {
  static constexpr std::array<unsigned char, 7> magic{0xab, 'K', 'T', 'X', ' ', '2', '0'};
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                                    [](unsigned char m, std::byte b) { return std::byte(m) == b; });
}

}  // namespace

/// T(offset) R S with v downwards: (u, v) -> offset + (c su u + s sv v, -s su u + c sv v). The extension's GLSL has the
/// other sign of s, but its text (counter-clockwise) and Khronos' TextureTransformTest have this one.
UvTransform uv_transform(const JsonView& info, Notes& notes) {
  const JsonView json = info.extension("KHR_texture_transform");
  const Vec2 offset = json["offset"].vec2({0, 0}), scale = json["scale"].vec2({1, 1});
  const float rotation = json["rotation"].number(0);
  const float c = std::cos(rotation), s = std::sin(rotation);
  UvTransform uv;
  uv.matrix = glm::mat3x2(c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x, offset.y);
  const std::size_t set = json["texCoord"].count(info["texCoord"].count(0));
  if (set > 1) notes.add("glTF texture coordinates beyond TEXCOORD_1 are not read; TEXCOORD_0 is used");
  uv.set = set == 1 ? 1 : 0;
  return uv;
}

std::optional<Textures::Source> Textures::source_of(const JsonView& info) {
  const JsonView texture = document_->referred("textures", info["index"]);
  const JsonView webp = texture.extension("EXT_texture_webp")["source"];
  const JsonView reference = webp ? webp : texture["source"];
  if (!reference) {
    document_->notes.add("a glTF texture without an image that can be read is left out");
    return std::nullopt;
  }
  const JsonView none = texture["sampler"];
  const JsonView sampler = none ? document_->referred("samplers", none) : none;
  MipMap::Settings settings;
  settings.wrap_u = wrap_of(sampler["wrapS"]);
  settings.wrap_v = wrap_of(sampler["wrapT"]);
  settings.filter = filter_of(sampler);
  return Source{document_->referred("images", reference), settings};
}

std::optional<Texels> Textures::decode(const JsonView& image) {
  std::optional<Resource> loaded;
  std::span<const std::byte> bytes;
  if (image["uri"]) {
    bytes = loaded.emplace(load_uri(image["uri"], document_->folder)).bytes();
    document_->budget.earn(bytes.size());
  } else {
    bytes = document_->buffers.view(image["bufferView"]).bytes;
  }
  if (is_ktx2(bytes)) {
    document_->notes.add("a KTX2 image is not read; its texture is left out");
    return std::nullopt;
  }
  Texels texels = decode_texels(bytes, image.place());
  document_->budget.charge(texels.bytes.size() + 4 * texels.floats.size(), 2, image);
  return texels;
}

std::shared_ptr<const MipMap> Textures::mip_map(const Source& source) {
  const MipMap::Settings& s = source.settings;
  auto& known = images_[{source.image.pointer(), s.wrap_u, s.wrap_v, s.filter, s.srgb}];
  if (known) return known;
  std::optional<Texels> texels = decode(source.image);
  if (texels) known = std::make_shared<const MipMap>(*std::move(texels), s);
  return known;
}

TextureId Textures::add(const JsonView& info, Encoding encoding) {
  if (!info) return no_texture;
  std::optional<Source> source = source_of(info);
  if (!source) return no_texture;
  source->settings.srgb = encoding == Encoding::srgb;
  const auto image = mip_map(*source);
  return image ? set_->add(ImageTexture{image, uv_transform(info, document_->notes)}) : no_texture;
}

TextureId Textures::add_roughness_of_glossiness(const JsonView& info, float factor) {
  const std::optional<Source> source = source_of(info);
  const std::optional<Texels> image = source ? decode(source->image) : std::nullopt;
  if (!image || image->channels % 2 != 0) return no_texture;
  Texels roughness{image->width, image->height, 1, {}, {}};
  const auto channels = static_cast<std::size_t>(image->channels);
  for (std::size_t i = channels - 1; i < image->bytes.size(); i += channels)
    roughness.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 - factor * image->bytes[i])));
  for (std::size_t i = channels - 1; i < image->floats.size(); i += channels)
    roughness.floats.push_back(1 - factor * image->floats[i]);
  const auto mip_map = std::make_shared<const MipMap>(std::move(roughness), source->settings);
  return set_->add(ImageTexture{mip_map, uv_transform(info, document_->notes)});
}

}  // namespace lambert::gltf
