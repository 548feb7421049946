#include "lambert/formats/gltf/textures.h"

#include "lambert/formats/gltf/gltf_test_tools.h"
#include "lambert/formats/gltf/uri.h"

namespace lambert::gltf {
namespace {

// 2 x 2: red, green; blue, half transparent white.
const std::string png =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR4nGP4z8DwHwyBNAg0AABJSQl4KKDbdwAAAABJRU5ErkJggg==";
const std::string webp =
    "data:image/webp;base64,UklGRjAAAABXRUJQVlA4TCMAAAAvAUAAEB8gEEjeHzqN+RcQFPwfnYCg6LrlImYPwg0YIvofAgA=";

/// A triangle with the image as the base colour's texture; `info` is added to its textureInfo.
TestDocument textured(const std::string& uri, std::string_view info = "{}") {
  TestDocument d = triangle_document();
  d.set("images", "[{}]").set("textures", R"([{"source": 0}])").set("materials", R"([{"pbrMetallicRoughness": {}}])");
  d["images"][0]["uri"] = uri;
  primitive(d)["material"] = 0;
  auto& texture = d["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  texture = nlohmann::json::parse(info);
  texture["index"] = 0;
  return d;
}
Texel lookup(const TestDocument& d, Vec2 uv, Vec2 uv1 = Vec2(0)) {
  const SceneGraph graph = read(d);
  const TextureId id = std::get<GltfMaterial>(first_material(graph).model).base_colour.texture;
  return graph.textures.eval(id, {.uv = uv, .uv1 = uv1});
}
void expect_texel(Texel a, Texel b) {
  expect_near(Vec3(a), Vec3(b));
  EXPECT_NEAR(a.w, b.w, 1e-5f);
}
const Texel red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1);

TEST(GltfTextures, PngAndWebp) {
  for (const std::string& image : {png, webp}) {
    const TestDocument d = textured(image);
    expect_texel(lookup(d, {0.25f, 0.25f}), red);
    expect_texel(lookup(d, {0.75f, 0.25f}), green);
    expect_texel(lookup(d, {0.25f, 0.75f}), blue);
    EXPECT_NEAR(lookup(d, {0.75f, 0.75f}).w, 128 / 255.0f, 1e-5f);
  }
}

TEST(GltfTextures, TheWebpExtensionWins) {
  TestDocument d = textured("no such file.png");
  d["images"].push_back({{"uri", webp}});
  d.set("textures", R"([{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}])");
  expect_texel(lookup(d, {0.25f, 0.25f}), red);
}

TEST(GltfTextures, ImagesInBufferViews) {
  const std::string file = "t";
  const Json nothing;
  std::string bytes;
  for (const std::byte b : decode_data_uri(png, JsonView(nothing, file))) bytes += static_cast<char>(b);
  TestDocument d = textured(png);
  d["images"][0].erase("uri");
  d["images"][0]["bufferView"] = d.view(bytes);
  expect_texel(lookup(d, {0.25f, 0.75f}), blue);
  d["bufferViews"][1]["byteLength"] = 40;
  EXPECT_NE(refusal(d).find("t.gltf: /images/0"), std::string::npos);
}

TEST(GltfTextures, SamplersWrap) {
  TestDocument d = textured(png);
  d.set("samplers", R"([{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}])");
  expect_texel(lookup(d, {1.25f, 0.25f}), red);
  d["textures"][0]["sampler"] = 0;
  expect_texel(lookup(d, {1.25f, 0.25f}), green);
  expect_texel(lookup(d, {0.25f, -0.25f}), red);
  expect_texel(lookup(d, {0.45f, 0.45f}), red);  // nearest
  d["samplers"][0]["wrapS"] = 5;
  EXPECT_NE(refusal(d).find("/samplers/0/wrapS: unknown wrap mode"), std::string::npos);
}

TEST(GltfTextures, TransformsMoveScaleAndTurn) {  // KHR_texture_transform
  const auto with = [](std::string_view transform, Vec2 uv) {
    return lookup(textured(png, R"({"extensions": {"KHR_texture_transform": )" + std::string(transform) + "}}"), uv);
  };
  expect_texel(with(R"({"offset": [0.5, 0]})", {0.25f, 0.25f}), green);
  expect_texel(with(R"({"scale": [3, 1]})", {0.25f, 0.25f}), green);
  // A quarter turn: (u, v) -> (v, -u), so that (-0.25, 0.75) becomes (0.75, 0.25).
  expect_texel(with(R"({"rotation": 1.57079633})", {-0.25f, 0.75f}), green);
  expect_texel(with(R"({"rotation": 1.57079633, "offset": [0, 1], "scale": [0.5, 1]})", {0.5f, 0.75f}),
               Texel(1, 1, 1, 128 / 255.0f));
}

TEST(GltfTextures, SetsOfCoordinates) {
  expect_texel(lookup(textured(png, R"({"texCoord": 1})"), {0.25f, 0.25f}, {0.75f, 0.25f}), green);
  const std::string overriding = R"({"texCoord": 1, "extensions": {"KHR_texture_transform": {"texCoord": 0}}})";
  expect_texel(lookup(textured(png, overriding), {0.25f, 0.25f}, {0.75f, 0.25f}), red);
  EXPECT_TRUE(has_note(notes_of(textured(png, R"({"texCoord": 2})")), "beyond TEXCOORD_1"));
}

TEST(GltfTextures, WhatCannotBeReadIsNamedOrNoted) {
  EXPECT_NE(refusal(textured("data:;base64,AAAA")).find("t.gltf: /images/0"), std::string::npos);
  EXPECT_NE(refusal(textured("none.png")).find("/images/0/uri"), std::string::npos);
  EXPECT_NE(refusal(textured(png.substr(0, png.size() - 40))).find("t.gltf: /images/0"), std::string::npos);
  EXPECT_TRUE(has_note(notes_of(textured("data:;base64,q0tUWCAyMA0K")), "KTX2"));
  TestDocument none = textured(png);
  none["textures"][0].erase("source");
  EXPECT_TRUE(has_note(notes_of(none), "without an image"));
  TestDocument index = textured(png);
  index["textures"][0]["source"] = 3;
  EXPECT_NE(refusal(index).find("/textures/0/source: refers to 3 of images"), std::string::npos);
}

TEST(GltfTextures, ImagesAreDecodedOncePerUse) {
  TestDocument d = textured(png);
  d["materials"][0]["emissiveTexture"]["index"] = 0;
  d["materials"][0]["emissiveFactor"] = {1, 1, 1};
  d["materials"][0]["normalTexture"]["index"] = 0;
  const SceneGraph graph = read(d);
  const auto image = [&](TextureId id) { return std::get<ImageTexture>(graph.textures[id]).image; };
  const auto base = std::get<GltfMaterial>(first_material(graph).model).base_colour.texture;
  const auto emissive = shown(graph)[0].surface.emission->radiance.texture;
  EXPECT_EQ(image(base), image(emissive));
  EXPECT_NE(image(base), image(first_material(graph).normal_map)) << "data are not sRGB";
}

TEST(GltfTextures, ChannelsGoWhereTheSpecificationSays) {
  TestDocument d = textured(png);
  d["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 0;
  const SceneGraph graph = read(d);
  const GltfMaterial m = std::get<GltfMaterial>(first_material(graph).model);
  const TextureCoordinates green_texel{.uv = Vec2(0.75f, 0.25f)}, blue_texel{.uv = Vec2(0.25f, 0.75f)};
  EXPECT_NEAR(m.roughness.eval(graph.textures, green_texel), 1, 1e-5f);
  EXPECT_NEAR(m.metallic.eval(graph.textures, green_texel), 0, 1e-5f);
  EXPECT_NEAR(m.metallic.eval(graph.textures, blue_texel), 1, 1e-5f);
}

}  // namespace
}  // namespace lambert::gltf
