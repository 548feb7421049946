#include "lambert/formats/gltf/uri.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

const std::string file = "f.gltf";
const Json nothing;
const JsonView place(nothing, file);

std::string decoded(std::string_view uri) {
  std::string text;
  for (const std::byte b : decode_data_uri(uri, place)) text += static_cast<char>(b);
  return text;
}
std::string refusal_of(std::string_view uri) {
  return error_of([&] { decode_data_uri(uri, place); });
}

TEST(GltfUri, Base64WithAndWithoutPadding) {  // RFC 4648, 10
  EXPECT_EQ(decoded("data:;base64,"), "");
  EXPECT_EQ(decoded("data:;base64,Zg=="), "f");
  EXPECT_EQ(decoded("data:;base64,Zm8"), "fo");
  EXPECT_EQ(decoded("data:application/gltf-buffer;base64,Zm9vYmFy"), "foobar");
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(decoded("data:;base64," + base64(all)), all);
}

TEST(GltfUri, PlainDataArePercentDecoded) { EXPECT_EQ(decoded("data:text/plain,a%20b%2Fc%zz%"), "a b/c%zz%"); }

TEST(GltfUri, DamagedDataAreNamed) {
  EXPECT_NE(refusal_of("data:;base64,Zm9*").find("'*' at character 16 is no base64 digit"), std::string::npos);
  EXPECT_NE(refusal_of("data:;base64,Zm9vY").find("ends in the middle of a byte"), std::string::npos);
  EXPECT_NE(refusal_of("data:;base64,Zg===").find("ends in the middle"), std::string::npos);
  EXPECT_NE(refusal_of("data:;base64").find("needs a comma"), std::string::npos);
}

TEST(GltfUri, FilesAreFoundBesideTheDocument) {
  const TemporaryFolder folder;
  folder.write("a b.bin", "1");
  folder.write("c%20d.bin", "2");
  EXPECT_EQ(resolve_uri("a%20b.bin", folder.path(), place), folder.path() / "a b.bin");
  EXPECT_EQ(resolve_uri("a b.bin", folder.path(), place), folder.path() / "a b.bin");
  EXPECT_EQ(resolve_uri("c%20d.bin", folder.path(), place), folder.path() / "c%20d.bin");
}

TEST(GltfUri, WhatCannotBeReadIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& uri) {
    return error_of([&] { resolve_uri(uri, folder.path(), place); });
  };
  EXPECT_NE(refused("none.bin").find("there is no file 'none.bin'"), std::string::npos);
  EXPECT_NE(refused("https://a.org/b.bin").find("is not on this machine"), std::string::npos);
  EXPECT_NE(refused("a%00.bin").find("there is no file"), std::string::npos);
  EXPECT_NE(refused("").find("there is no file"), std::string::npos);
  EXPECT_NE(error_of([&] { resolve_uri("a.bin", {}, place); }).find("cannot be read from here"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
