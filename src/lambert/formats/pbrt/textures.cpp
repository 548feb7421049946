#include "lambert/formats/pbrt/textures.h"

#include "lambert/formats/pbrt/image_textures.h"

namespace lambert::pbrt {
namespace {

template <class Map>
std::vector<std::string> keys(const Map& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

template <class Value>
Value named_texture(const ByName<Value>& textures, const Parameter& p, const char* type) {
  if (p.strings.size() != 1) p.fail("texture '" + p.name + "' takes one name");
  const auto found = textures.find(p.strings[0]);
  if (found == textures.end()) {
    p.fail(std::string("unknown ") + type + " texture " + unknown_word(p.strings[0], keys(textures)));
  }
  return found->second;
}

/// As a texture, for textures that refer to others.
TextureId texture_of(Context& context, const RgbParameter& p) {
  if (p.texture != no_texture && p.value == Rgb(1.0f)) return p.texture;
  const TextureId value = context.graph.textures.add(ConstantTexture{{p.value.r, p.value.g, p.value.b, 1}});
  return p.texture == no_texture ? value : context.graph.textures.add(ScaleTexture{p.texture, value});
}
TextureId texture_of(Context& context, const FloatParameter& p) {
  return texture_of(context, RgbParameter{Rgb(p.value), p.texture});
}

// The two kinds of texture differ in their parameters' type alone; these overloads are that difference.
RgbParameter parameter(const Context& c, const ParameterList& list, std::string_view name, Rgb fallback) {
  return rgb_parameter(c, list, name, fallback, SpectrumRole::unbounded);
}
FloatParameter parameter(const Context& c, const ParameterList& list, std::string_view name, float fallback) {
  return float_parameter(c, list, name, fallback);
}
RgbParameter with_texture(RgbParameter, TextureId t) { return {Rgb(1.0f), t}; }
FloatParameter with_texture(FloatParameter, TextureId t) { return {1, t}; }
float product(const FloatParameter& a, const FloatParameter& b) { return a.value * b.value; }
Rgb product(const RgbParameter& a, const RgbParameter& b) { return a.value * b.value; }
Rgb product(const RgbParameter& a, const FloatParameter& b) { return a.value * b.value; }

template <class Value>
auto constant(float v) {
  if constexpr (std::is_same_v<Value, RgbParameter>) {
    return Rgb(v);
  } else {
    return v;
  }
}

template <class Value>
Value scale_texture(Context& context, const ParameterList& list) {
  const Value texture = parameter(context, list, "tex", constant<Value>(1));
  const Parameter* scale = list.find("scale", {ParameterType::floating, ParameterType::rgb, ParameterType::spectrum,
                                               ParameterType::blackbody, ParameterType::texture});
  const bool is_single = scale && (scale->type == ParameterType::floating ||
                                   (scale->type == ParameterType::texture && scale->strings.size() == 1 &&
                                    context.float_textures.contains(scale->strings[0])));
  Value result = texture;
  const auto multiply = [&](const auto& factor) {
    result.value = product(texture, factor);
    if (factor.texture == no_texture) return;
    result.texture = texture.texture == no_texture
                         ? factor.texture
                         : context.graph.textures.add(ScaleTexture{texture.texture, factor.texture});
  };
  if constexpr (std::is_same_v<Value, RgbParameter>) {
    if (!is_single) {
      multiply(parameter(context, list, "scale", Rgb(1.0f)));
      return result;
    }
  }
  multiply(float_parameter(context, list, "scale", 1));
  return result;
}

template <class Value>
Value mix_texture(Context& context, const ParameterList& list) {
  const Value a = parameter(context, list, "tex1", constant<Value>(0));
  const Value b = parameter(context, list, "tex2", constant<Value>(1));
  const FloatParameter amount = float_parameter(context, list, "amount", 0.5f);
  const MixTexture mix{texture_of(context, a), texture_of(context, b), texture_of(context, amount)};
  return with_texture(a, context.graph.textures.add(mix));
}

template <class Value>
Value checkerboard_texture(Context& context, const ParameterList& list, const GraphicsState& state) {
  const Value even = parameter(context, list, "tex1", constant<Value>(1));
  const Value odd = parameter(context, list, "tex2", constant<Value>(0));
  CheckerboardTexture board;
  board.even = texture_of(context, even), board.odd = texture_of(context, odd);
  board.dimensions = list.integer("dimension", 2);
  if (board.dimensions != 2 && board.dimensions != 3) list.fail("\"integer dimension\" must be 2 or 3");
  if (board.dimensions == 2) board.uv = uv_mapping(list, false);
  if (board.dimensions == 3 && !state.ctm.is_identity()) {
    context.notes.add("the transformation of a 3D checkerboard is ignored");
  }
  return with_texture(even, context.graph.textures.add(board));
}

template <class Value>
Value make_texture(Context& context, const ParameterList& list, const std::string& type_class,
                   const GraphicsState& state) {
  if (type_class == "constant") return parameter(context, list, "value", constant<Value>(1));
  if (type_class == "imagemap") {
    const ImageTexture image = image_texture(context, list, std::is_same_v<Value, FloatParameter>);
    return with_texture(Value(), context.graph.textures.add(image));
  }
  if (type_class == "scale") return scale_texture<Value>(context, list);
  if (type_class == "mix") return mix_texture<Value>(context, list);
  if (type_class == "checkerboard") return checkerboard_texture<Value>(context, list, state);
  fail_unknown_type(list, "texture class", type_class, texture_classes());
}

}  // namespace

std::vector<std::string> texture_classes() { return {"constant", "imagemap", "scale", "mix", "checkerboard"}; }

FloatParameter float_parameter(const Context& context, const ParameterList& list, std::string_view name,
                               float fallback) {
  const Parameter* p = list.find(name, {ParameterType::floating, ParameterType::texture});
  if (p && p->type == ParameterType::texture) return named_texture(context.float_textures, *p, "float");
  return {list.number(name, fallback)};
}

RgbParameter rgb_parameter(const Context& context, const ParameterList& list, std::string_view name, Rgb fallback,
                           SpectrumRole role) {
  const Parameter* p =
      list.find(name, {ParameterType::rgb, ParameterType::spectrum, ParameterType::blackbody, ParameterType::texture});
  if (!p) return {fallback};
  if (p->type == ParameterType::texture) return named_texture(context.spectrum_textures, *p, "spectrum");
  return {rgb_value(context, *p, role)};
}

void add_float_texture(Context& context, const ParameterList& list, const std::string& name,
                       const std::string& type_class, const GraphicsState& state) {
  context.float_textures[name] = make_texture<FloatParameter>(context, list, type_class, state);
}
void add_spectrum_texture(Context& context, const ParameterList& list, const std::string& name,
                          const std::string& type_class, const GraphicsState& state) {
  context.spectrum_textures[name] = make_texture<RgbParameter>(context, list, type_class, state);
}

}  // namespace lambert::pbrt
