#include "lambert/formats/gltf/container.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

namespace lambert::gltf {
namespace {

Container split(const std::string& data) {
  return split_container(std::as_bytes(std::span(data.data(), data.size())), "f.glb");
}
std::string words(const std::vector<std::size_t>& values) { return TestDocument::words(values); }
/// A GLB whose header says that `after_header` is all.
std::string glb(const std::string& after_header) {
  return "glTF" + words({2, 12 + after_header.size()}) + after_header;
}
std::string chunk(const std::string& type, const std::string& content) {
  return words({content.size()}) + type + content;
}
const std::string bin("BIN\0", 4);

TEST(GltfContainer, TextIsJson) {
  const std::string text = "{}";
  EXPECT_EQ(split(text).json, "{}");
  EXPECT_TRUE(split(text).binary.empty());
}

TEST(GltfContainer, ChunksComeApart) {
  const std::string data = glb(chunk("JSON", "{}  ") + chunk(bin, "abcd") + chunk("XTRA", "more"));
  EXPECT_EQ(split(data).json, "{}  ");
  ASSERT_EQ(split(data).binary.size(), 4u);
  EXPECT_EQ(split(data).binary[1], std::byte{'b'});
}

TEST(GltfContainer, TheBinaryChunkIsOptionalAndPaddingIsHarmless) {
  EXPECT_TRUE(split(glb(chunk("JSON", "{}"))).binary.empty());
  EXPECT_EQ(split(glb(chunk("JSON", "{}") + std::string(5, '\0'))).json, "{}");
  EXPECT_EQ(split(glb(chunk("JSON", "{}")) + "behind the end").json, "{}");
}

TEST(GltfContainer, ErrorsNameTheByte) {
  const auto refused = [](const std::string& data) { return error_of([&] { split(data); }); };
  EXPECT_EQ(refused("glTF\2"), "f.glb: GLB at byte 5: the header is cut off");
  EXPECT_EQ(refused("glTF" + words({1, 12})), "f.glb: GLB at byte 4: expected version 2, found 1");
  EXPECT_EQ(refused("glTF" + words({2, 99})), "f.glb: GLB at byte 8: says that it has 99 bytes, but the file has 12");
  EXPECT_EQ(refused(glb("")), "f.glb: GLB at byte 12: there is no JSON chunk");
  EXPECT_EQ(refused(glb(chunk(bin, "abcd"))), "f.glb: GLB at byte 16: expected the JSON chunk first");
  EXPECT_EQ(refused(glb(words({0xffffffff}) + "JSON{}")),
            "f.glb: GLB at byte 12: a chunk of 4294967295 bytes does not fit into the file");
}

TEST(GltfContainer, BothFormsShowTheSameScene) {
  const TestDocument d = triangle_document();
  Notes notes;
  const SceneGraph binary = read(d.glb(), notes), text = read(d.text(), notes);
  EXPECT_EQ(mesh_of(binary).positions, mesh_of(text).positions);
}

TEST(GltfContainer, ABufferWithoutDataIsRefused) {
  TestDocument d = triangle_document();
  const std::string data = d.glb();
  const std::string json_only = data.substr(20, data.find("BIN") - 4 - 20);
  Notes notes;
  EXPECT_EQ(error_of([&] { read(json_only, notes); }),
            "t.gltf: /buffers/0: has neither a uri nor the binary chunk of a GLB file");
}

}  // namespace
}  // namespace lambert::gltf
