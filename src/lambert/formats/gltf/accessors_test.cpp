#include "lambert/formats/gltf/accessors.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

#include <limits>

namespace lambert::gltf {
namespace {

/// The document's accessor 0, read as floats.
std::vector<float> floats(TestDocument d, const Selection& selection = {}) {
  d["reference"] = 0;
  OpenDocument open(d);
  return open.document.accessor(open.document.root()["reference"]).floats(selection);
}
std::vector<std::uint32_t> integers(TestDocument d) {
  d["reference"] = 0;
  OpenDocument open(d);
  return open.document.accessor(open.document.root()["reference"]).integers();
}
std::string refused(const TestDocument& d) {
  return error_of([&] { floats(d); });
}

template <class T>
void expect_type(const std::vector<float>& plain, const std::vector<float>& normalized) {
  const T most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::lowest();
  TestDocument d;
  d.accessor<T>("SCALAR", {0, 1, most, least});
  EXPECT_EQ(floats(d), plain);
  d["accessors"][0]["normalized"] = true;
  EXPECT_EQ(floats(d), normalized);
}

TEST(GltfAccessors, AllComponentTypesPlainAndNormalized) {  // glTF 2.0, 3.11: max(c / 127, -1) and the like
  expect_type<std::int8_t>({0, 1, 127, -128}, {0, 1 / 127.0f, 1, -1});
  expect_type<std::uint8_t>({0, 1, 255, 0}, {0, 1 / 255.0f, 1, 0});
  expect_type<std::int16_t>({0, 1, 32767, -32768}, {0, 1 / 32767.0f, 1, -1});
  expect_type<std::uint16_t>({0, 1, 65535, 0}, {0, 1 / 65535.0f, 1, 0});
  TestDocument d;
  d.accessor<float>("VEC2", {1.5f, -2, 3, 4});
  EXPECT_EQ(floats(d), (std::vector<float>{1.5f, -2, 3, 4}));
}

TEST(GltfAccessors, Integers) {
  TestDocument bytes, shorts, words, signed_ones;
  bytes.accessor<std::uint8_t>("SCALAR", {1, 255});
  shorts.accessor<std::uint16_t>("SCALAR", {1, 65535});
  words.accessor<std::uint32_t>("SCALAR", {1, 4294967295u});
  signed_ones.accessor<std::int16_t>("SCALAR", {1});
  EXPECT_EQ(integers(bytes), (std::vector<std::uint32_t>{1, 255}));
  EXPECT_EQ(integers(shorts), (std::vector<std::uint32_t>{1, 65535}));
  EXPECT_EQ(integers(words), (std::vector<std::uint32_t>{1, 4294967295u}));
  EXPECT_NE(error_of([&] { integers(signed_ones); }).find("/accessors/0/componentType: expected unsigned integers"),
            std::string::npos);
}

TEST(GltfAccessors, InterleavedElements) {
  TestDocument d;
  const std::size_t view = d.view(as_bytes_of(std::vector<float>{1, 2, 3, 10, 4, 5, 6, 20, 7, 8, 9, 30}), 16);
  d.accessor_on(view, 5126, "SCALAR", 3, 12);
  EXPECT_EQ(floats(d), (std::vector<float>{10, 20, 30}));
  EXPECT_EQ(floats(d, {0, 2}), (std::vector<float>{10, 30}));
  d["accessors"][0]["count"] = 4;
  EXPECT_EQ(refused(d),
            "t.gltf: /accessors/0: 4 elements from byte 12 do not fit into the 48 bytes of the buffer view");
}

TestDocument sparse_document() {
  TestDocument d;
  const std::size_t indices = d.view(as_bytes_of(std::vector<std::uint8_t>{1, 3}));
  const std::size_t values = d.view(as_bytes_of(std::vector<float>{10, 30}));
  d.set("accessors", R"([{"componentType": 5126, "type": "SCALAR", "count": 4,
      "sparse": {"count": 2, "indices": {"componentType": 5121}, "values": {}}}])");
  d["accessors"][0]["sparse"]["indices"]["bufferView"] = indices;
  d["accessors"][0]["sparse"]["values"]["bufferView"] = values;
  return d;
}

TEST(GltfAccessors, SparseElementsReplaceZerosOrOthers) {
  TestDocument d = sparse_document();
  EXPECT_EQ(floats(d), (std::vector<float>{0, 10, 0, 30}));
  EXPECT_EQ(floats(d, {0, 3}), (std::vector<float>{0, 30}));
  d["accessors"][0]["bufferView"] = d.view(as_bytes_of(std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(floats(d), (std::vector<float>{1, 10, 3, 30}));
}

TEST(GltfAccessors, SparseErrors) {
  TestDocument d = sparse_document();
  d["accessors"][0]["count"] = 3;
  EXPECT_EQ(refused(d), "t.gltf: /accessors/0/sparse/indices: index 3 is out of range: there are 3 elements");
  d["accessors"][0]["sparse"]["count"] = 3;
  EXPECT_NE(refused(d).find("/accessors/0/sparse/values: 3 elements from byte 0 do not fit"), std::string::npos);
  d["accessors"][0]["sparse"]["indices"]["componentType"] = 5126;
  d["accessors"][0]["sparse"]["count"] = 1;
  EXPECT_NE(refused(d).find("/sparse/indices/componentType: expected unsigned"), std::string::npos);
}

TEST(GltfAccessors, LyingNumbersAreRefusedWhereTheyStand) {
  const auto refused_with = [](const char* member, const nlohmann::json& value) {
    TestDocument d;
    d.accessor<float>("VEC3", {1, 2, 3});
    d["accessors"][0][member] = value;
    return refused(d);
  };
  EXPECT_NE(refused_with("count", 4294967295u).find("/accessors/0: 4294967295 elements"), std::string::npos);
  EXPECT_NE(refused_with("count", 1e15).find("/accessors/0/count: expected less than 2^32"), std::string::npos);
  EXPECT_NE(refused_with("count", -1).find("/accessors/0/count: expected a whole number"), std::string::npos);
  EXPECT_NE(refused_with("byteOffset", 9007199254740992.0).find("do not fit"), std::string::npos);
  EXPECT_NE(refused_with("componentType", 5124).find("unknown component type 5124"), std::string::npos);
  EXPECT_NE(refused_with("type", "VEC5").find("unknown type 'VEC5'"), std::string::npos);
  EXPECT_NE(refused_with("bufferView", 7).find("refers to 7 of bufferViews, but there are 1"), std::string::npos);
}

TEST(GltfAccessors, ManyElementsWithoutMemoryAreRefused) {
  TestDocument d;
  d.set("accessors", R"([{"componentType": 5126, "type": "MAT4", "count": 4000000000}])");
  EXPECT_EQ(
      refused(d),
      "t.gltf: /accessors/0/count: asks for 4000000000 items, which is out of proportion to the size of the file");
}

TEST(GltfAccessors, NumbersThatAreNotFiniteAreNamed) {
  TestDocument d;
  d.accessor<float>("VEC2", {0, 0, 1, 1, 2, std::numeric_limits<float>::quiet_NaN()});
  EXPECT_EQ(refused(d), "t.gltf: /accessors/0: element 2 is not finite");
  EXPECT_EQ(error_of([&] { floats(d, {0, 2}); }), "t.gltf: /accessors/0: element 2 is not finite");
  EXPECT_NO_THROW(floats(d, {0, 1}));
}

TEST(GltfAccessors, BufferViewsMustLieInTheirBuffer) {
  TestDocument d;
  d.accessor<float>("VEC3", {1, 2, 3});
  d["bufferViews"][0]["byteOffset"] = 4;
  EXPECT_EQ(refused(d), "t.gltf: /bufferViews/0: bytes 4 to 16 lie outside of the buffer, which has 12");
  d["bufferViews"][0]["buffer"] = 1;
  EXPECT_NE(refused(d).find("/bufferViews/0/buffer: refers to 1 of buffers"), std::string::npos);
  d["bufferViews"][0]["buffer"] = 0;
  d["bufferViews"][0]["byteOffset"] = 0;
  d["bufferViews"][0]["byteStride"] = 400;
  EXPECT_NE(refused(d).find("/bufferViews/0/byteStride: expected at most 252"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
