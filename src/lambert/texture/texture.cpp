#include "lambert/texture/texture.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace lambert {
namespace {

/// The mean over [x - w/2, x + w/2] of the function that is 0 on [2k, 2k + 1) and 1 on [2k + 1, 2k + 2).
float filtered_parity(float x, float w) {
  const auto integral = [](float v) {
    const float half = std::floor(0.5f * v);
    return half + std::max(0.0f, v - 2 * half - 1);
  };
  if (!(w > 1e-4f)) return static_cast<float>(static_cast<std::int64_t>(std::floor(x)) & 1);
  x -= 2 * std::floor(0.5f * x);  // far from 0 the difference of the integrals would lose its digits
  return (integral(x + 0.5f * w) - integral(x - 0.5f * w)) / w;
}

/// The share of the odd squares in the footprint: p (1 - q) + q (1 - p) of the parities along both axes.
float odd_share(const CheckerboardTexture& c, const TextureCoordinates& at) {
  const auto tame = [](float x) { return std::isfinite(x) ? std::clamp(x, -1e6f, 1e6f) : 0; };
  if (c.dimensions == 3) {
    const auto cell = [&](float x) { return static_cast<std::int64_t>(std::floor(tame(x))); };
    return static_cast<float>((cell(at.position.x) + cell(at.position.y) + cell(at.position.z)) & 1);
  }
  const Vec2 uv = c.uv.apply(at);
  const float w = tame(at.footprint * c.uv.scale());
  const float p = filtered_parity(tame(uv.x), w), q = filtered_parity(tame(uv.y), w);
  return p * (1 - q) + q * (1 - p);
}

struct Eval {
  const TextureSet& set;
  const TextureCoordinates& at;

  Texel operator()(const ConstantTexture& t) const { return t.value; }
  Texel operator()(const ImageTexture& t) const {
    Texel v = t.image->lookup(t.uv.apply(at), at.footprint * t.uv.scale());
    if (t.invert) v = {1 - v.x, 1 - v.y, 1 - v.z, v.w};
    return v * t.scale;
  }
  Texel operator()(const ScaleTexture& t) const { return set.eval(t.texture, at) * set.eval(t.factor, at); }
  Texel operator()(const MixTexture& t) const {
    const float amount = set.eval(t.amount, at).x;
    if (amount <= 0) return set.eval(t.a, at);
    if (amount >= 1) return set.eval(t.b, at);
    return (1 - amount) * set.eval(t.a, at) + amount * set.eval(t.b, at);
  }
  Texel operator()(const CheckerboardTexture& t) const {
    const float odd = odd_share(t, at);
    if (odd <= 0) return set.eval(t.even, at);
    if (odd >= 1) return set.eval(t.odd, at);
    return (1 - odd) * set.eval(t.even, at) + odd * set.eval(t.odd, at);
  }
};

std::vector<TextureId> children(const Texture& t) {
  if (const auto* s = std::get_if<ScaleTexture>(&t)) return {s->texture, s->factor};
  if (const auto* m = std::get_if<MixTexture>(&t)) return {m->a, m->b, m->amount};
  if (const auto* c = std::get_if<CheckerboardTexture>(&t)) return {c->even, c->odd};
  return {};
}

}  // namespace

TextureId TextureSet::add(Texture t) {
  for (const TextureId child : children(t))
    if (child >= textures_.size())
      throw Error("texture " + std::to_string(textures_.size()) + " refers to texture " + std::to_string(child) +
                  ", which does not come before it");
  textures_.push_back(std::move(t));
  return static_cast<TextureId>(textures_.size() - 1);
}

Texel TextureSet::eval(TextureId id, const TextureCoordinates& at) const {
  return std::visit(Eval{*this, at}, textures_[id]);
}

}  // namespace lambert
