#include "lambert/formats/gltf/extensions.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

TEST(GltfExtensions, RequiredOnesMustBeKnown) {
  TestDocument d = triangle_document();
  d["extensionsRequired"] = {"KHR_materials_ior", "KHR_texture_basisu"};
  const std::string error = refusal(d);
  EXPECT_TRUE(error.starts_with("t.gltf: /extensionsRequired/1: the document requires an unknown extension"));
  EXPECT_NE(error.find("'KHR_texture_basisu'"), std::string::npos);
}

TEST(GltfExtensions, UsedOnesAreNoted) {
  TestDocument d = triangle_document();
  d["extensionsUsed"] = {"KHR_xmp_json_ld", "KHR_materials_sheen"};
  EXPECT_TRUE(has_note(notes_of(d), "KHR_xmp_json_ld is ignored"));
  EXPECT_FALSE(has_note(notes_of(d), "KHR_materials_sheen"));
}

TEST(GltfExtensions, VersionsOtherThanTwoAreRefused) {
  const auto with = [](std::string_view asset) {
    TestDocument d = triangle_document();
    return refusal(d.set("asset", asset));
  };
  EXPECT_EQ(with(R"({"version": "1.0"})"), "t.gltf: /asset/version: expected glTF version 2.0, found '1.0'");
  EXPECT_EQ(with(R"({"version": "2.1", "minVersion": "2.1"})"),
            "t.gltf: /asset/minVersion: expected glTF version 2.0, found '2.1'");
  EXPECT_NE(with(R"({"version": 2.0})").find("/asset/version: expected a string, found a number"), std::string::npos);
  TestDocument later = triangle_document();
  EXPECT_NO_THROW(read(later.set("asset", R"({"version": "2.1"})")));
  TestDocument none = triangle_document();
  none.json.erase("asset");
  EXPECT_EQ(refusal(none), "t.gltf: /asset: is missing: this is no glTF document");
}

}  // namespace
}  // namespace lambert::gltf
