#include "lambert/formats/gltf/draco.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

namespace lambert::gltf {
namespace {

const std::vector<std::array<Vec3, 3>> square{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};

std::string encoded_square(int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (std::uint32_t f = 0; f < 2; ++f) {
    const auto& t = square[f];
    const std::array<Vec2, 3> uvs{Vec2(t[0]), Vec2(t[1]), Vec2(t[2])};
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), &t[0], &t[1], &t[2]);
    builder.SetAttributeValuesForFace(uv, draco::FaceIndex(f), &uvs[0], &uvs[1], &uvs[2]);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

TestDocument document(const std::string& data) {
  TestDocument d = triangle_document();
  d.set("accessors", R"([{"componentType": 5126, "type": "VEC3", "count": 4},
      {"componentType": 5126, "type": "VEC2", "count": 4}, {"componentType": 5123, "type": "SCALAR", "count": 6}])");
  primitive(d) = nlohmann::json::parse(R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2,
      "extensions": {"KHR_draco_mesh_compression": {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}}})");
  primitive(d)["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = d.view(data);
  return d;
}
nlohmann::json& extension(TestDocument& d) { return primitive(d)["extensions"]["KHR_draco_mesh_compression"]; }
const std::string place = "t.gltf: /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

TEST(GltfDraco, BothEncodings) {
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const SceneGraph graph = read(document(encoded_square(method)));
    const TriangleMesh& mesh = mesh_of(graph);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_NEAR(mesh.area(), 1, 1e-3f);
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i) EXPECT_NEAR(mesh.uvs[i].y, mesh.positions[i].y, 1e-3f);
    for (const Triangle t : mesh.triangles)
      EXPECT_GT(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).z, 0);
  }
}

TEST(GltfDraco, LiesAreNamed) {
  const std::string good = encoded_square(draco::MESH_EDGEBREAKER_ENCODING);
  TestDocument faces = document(good);
  faces["accessors"][2]["count"] = 3;
  EXPECT_EQ(refusal(faces), place + ": the Draco data announce 2 faces, but the indices are 3");
  TestDocument id = document(good);
  extension(id)["attributes"]["POSITION"] = 7;
  EXPECT_EQ(refusal(id), place + "/attributes/POSITION: the Draco data have no such attribute");
  TestDocument width = document(good);
  extension(width)["attributes"]["POSITION"] = 1;
  EXPECT_EQ(refusal(width), place + "/attributes/POSITION: has another number of components than its accessor");
}

TEST(GltfDraco, DamagedDataAreRefusedOrRead) {
  const std::string good = encoded_square(draco::MESH_EDGEBREAKER_ENCODING);
  EXPECT_EQ(refusal(document("DRACO")), place + ": the Draco data are malformed or of an old version");
  EXPECT_TRUE(refusal(document(good.substr(0, good.size() / 2))).starts_with(place));
  int refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const int value : {0, 0x7f, 0xff}) {
      std::string bad = good;
      bad[i] = static_cast<char>(value);
      try {
        read(document(bad));
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace lambert::gltf
