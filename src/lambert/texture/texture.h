#pragma once
/// Textures: a closed set of small structs that refer to each other by index in a TextureSet.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"
#include "lambert/texture/mip_map.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace lambert {

using TextureId = std::uint32_t;
inline constexpr TextureId no_texture = ~TextureId{0};

/// Where a texture is looked up.
struct TextureCoordinates {
  Vec2 uv{0};
  Vec2 uv1{0};          ///< second set (glTF TEXCOORD_1)
  float footprint = 0;  ///< width of the filter in uv units; 0 means a point
  Vec3 position{0};     ///< world
};

/// uv' = matrix * (u, v, 1); which set of coordinates it reads.
struct UvTransform {
  glm::mat3x2 matrix{1, 0, 0, 1, 0, 0};  // columns: images of u, of v, and the offset
  std::uint32_t set = 0;
  Vec2 apply(const TextureCoordinates& c) const {
    const Vec2 uv = set == 1 ? c.uv1 : c.uv;
    return matrix[0] * uv.x + matrix[1] * uv.y + matrix[2];
  }
  float scale() const { return std::sqrt(std::abs(matrix[0].x * matrix[1].y - matrix[0].y * matrix[1].x)); }
};

/// RGBA, linear; one-channel uses read .r. Straight alpha.
using Texel = Vec4;

struct ConstantTexture {
  Texel value{1, 1, 1, 1};
};
struct ImageTexture {
  std::shared_ptr<const MipMap> image;
  UvTransform uv;
  Texel scale{1, 1, 1, 1};
  bool invert = false;  ///< 1 - value after the lookup, before the scale (pbrt)
};
struct ScaleTexture {
  TextureId texture = no_texture, factor = no_texture;
};
struct MixTexture {
  TextureId a = no_texture, b = no_texture, amount = no_texture;  ///< (1 - amount) a + amount b
};
struct CheckerboardTexture {
  TextureId even = no_texture, odd = no_texture;
  UvTransform uv;
  int dimensions = 2;  ///< 3 uses the position
};
using Texture = std::variant<ConstantTexture, ImageTexture, ScaleTexture, MixTexture, CheckerboardTexture>;

class TextureSet {
 public:
  /// Ids a texture refers to must already be in the set (so that there are no cycles); throws Error otherwise.
  TextureId add(Texture t);
  std::size_t size() const { return textures_.size(); }
  const Texture& operator[](TextureId id) const { return textures_[id]; }
  Texel eval(TextureId id, const TextureCoordinates& at) const;

 private:
  std::vector<Texture> textures_;
};

/// A material's parameter: a constant, times a texture when there is one.
struct RgbParameter {
  Rgb value{1.0f};
  TextureId texture = no_texture;
  Rgb eval(const TextureSet& set, const TextureCoordinates& at) const {
    if (texture == no_texture) return value;
    const Texel t = set.eval(texture, at);
    return value * Rgb(t.x, t.y, t.z);
  }
};
struct FloatParameter {
  float value = 1;
  TextureId texture = no_texture;
  int channel = 0;  ///< 0 red … 3 alpha
  float eval(const TextureSet& set, const TextureCoordinates& at) const {
    return texture == no_texture ? value : value * set.eval(texture, at)[channel];
  }
};

}  // namespace lambert
