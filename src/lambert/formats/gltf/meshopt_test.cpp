#include "lambert/formats/gltf/meshopt.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

#include <meshoptimizer.h>

namespace lambert::gltf {
namespace {

std::string compressed_vertices(const std::string& bytes, std::size_t count) {
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, bytes.size() / count));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), bytes.data(), count, bytes.size() / count));
  return as_bytes_of(out);
}

/// Makes buffer view `view` a compressed one, whose data are those of buffer view `data`.
nlohmann::json& compress(TestDocument& d, std::size_t view, std::size_t data, const char* mode, std::size_t count,
                         std::size_t stride) {
  nlohmann::json& e = d["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
  e["buffer"] = 0;
  e["byteOffset"] = d["bufferViews"][data]["byteOffset"];
  e["byteLength"] = d["bufferViews"][data]["byteLength"];
  e["mode"] = mode;
  e["count"] = count;
  e["byteStride"] = stride;
  return e;
}

const std::vector<float> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

/// A square whose positions are compressed; buffer view 1 is theirs.
TestDocument compressed_square() {
  TestDocument d = triangle_document();
  const std::size_t positions = d.accessor<float>("VEC3", square);
  compress(d, 1, d.view(compressed_vertices(as_bytes_of(square), 4)), "ATTRIBUTES", 4, 12);
  // The fallback must not be needed.
  d["bufferViews"][1]["buffer"] = 99;
  primitive(d)["attributes"]["POSITION"] = positions;
  primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", {0, 1, 2, 0, 2, 3});
  return d;
}
nlohmann::json& extension(TestDocument& d) { return d["bufferViews"][1]["extensions"]["EXT_meshopt_compression"]; }

TEST(GltfMeshopt, Attributes) {
  const SceneGraph graph = read(compressed_square());
  EXPECT_EQ(mesh_of(graph).positions, grouped<Vec3>(square));
}

TEST(GltfMeshopt, IndicesAndTriangles) {
  const std::vector<unsigned> indices{0, 1, 2, 0, 2, 3};
  for (const bool triangles : {false, true}) {
    std::vector<unsigned char> coded(1000);
    coded.resize(triangles ? meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices.data(), indices.size())
                           : meshopt_encodeIndexSequence(coded.data(), coded.size(), indices.data(), indices.size()));
    for (const std::size_t size : {2u, 4u}) {
      TestDocument d = compressed_square();
      const std::size_t data = d.view(as_bytes_of(coded)), view = d.view("");
      compress(d, view, data, triangles ? "TRIANGLES" : "INDICES", 6, size);
      primitive(d)["indices"] = d.accessor_on(view, size == 2 ? 5123 : 5125, "SCALAR", 6);
      const SceneGraph graph = read(d);
      EXPECT_NEAR(mesh_of(graph).area(), 1, 1e-6f);
      EXPECT_EQ(mesh_of(graph).triangles.size(), 2u);
    }
  }
}

TEST(GltfMeshopt, OctahedralNormals) {
  const std::vector<float> normals{0, 0, 1, 0, 0.6f, 0, 0.8f, 0, 0, 1, 0, 0, -1, 0, 0, 0};  // xyz and a spare
  std::vector<std::int8_t> coded(16);
  meshopt_encodeFilterOct(coded.data(), 4, 4, 8, normals.data());
  TestDocument d = compressed_square();
  const std::size_t data = d.view(compressed_vertices(as_bytes_of(coded), 4)), view = d.view("");
  compress(d, view, data, "ATTRIBUTES", 4, 4)["filter"] = "OCTAHEDRAL";
  const std::size_t a = d.accessor_on(view, 5120, "VEC3", 4);
  d["accessors"][a]["normalized"] = true;
  primitive(d)["attributes"]["NORMAL"] = a;
  const SceneGraph graph = read(d);
  for (std::size_t i = 0; i < 4; ++i)
    expect_near(mesh_of(graph).normals[i], {normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]}, 0.02f);
}

TEST(GltfMeshopt, ExponentialFloats) {
  std::vector<std::uint32_t> coded(12);
  std::vector<float> positions{0, 0, 0, 1000, 0, 0, 1000, 0.25f, 0, 0, 0.25f, 0};
  meshopt_encodeFilterExp(coded.data(), 4, 12, 15, positions.data());
  TestDocument d = compressed_square();
  const std::size_t data = d.view(compressed_vertices(as_bytes_of(coded), 4)), view = d.view("");
  compress(d, view, data, "ATTRIBUTES", 4, 12)["filter"] = "EXPONENTIAL";
  primitive(d)["attributes"]["POSITION"] = d.accessor_on(view, 5126, "VEC3", 4);
  EXPECT_NEAR(mesh_of(read(d)).area(), 250, 0.5f);
}

TEST(GltfMeshopt, DamageIsNamed) {
  const auto refused = [](const char* member, const nlohmann::json& value) {
    TestDocument d = compressed_square();
    extension(d)[member] = value;
    return refusal(d);
  };
  const std::string place = "t.gltf: /bufferViews/1/extensions/EXT_meshopt_compression";
  EXPECT_EQ(refused("byteLength", 20), place + ": the compressed data are malformed");
  EXPECT_EQ(refused("byteOffset", 0), place + ": the compressed data are malformed");
  EXPECT_EQ(refused("count", 4000000000u), place + "/count: is more than the compressed data can hold");
  EXPECT_EQ(refused("byteStride", 10), place + "/byteStride: does not fit the mode ATTRIBUTES");
  EXPECT_NE(refused("mode", "ATRIBUTES").find("did you mean 'ATTRIBUTES'"), std::string::npos);
  EXPECT_NE(refused("filter", "NOON").find("unknown filter 'NOON'"), std::string::npos);
  EXPECT_EQ(refused("filter", "OCTAHEDRAL"), place + "/filter: does not fit the mode and byteStride");
  EXPECT_NE(refused("byteLength", 100000).find(place + ": bytes"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
