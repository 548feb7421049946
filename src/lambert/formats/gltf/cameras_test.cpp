#include "lambert/formats/gltf/cameras.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

#include <cmath>

namespace lambert::gltf {
namespace {

SceneGraph with_camera(std::string_view camera, std::string_view node = R"({"camera": 0})") {
  TestDocument d;
  d.set("cameras", "[" + std::string(camera) + "]").set("nodes", "[" + std::string(node) + "]");
  return read(d);
}
std::string refused(std::string_view camera, std::string_view node = R"({"camera": 0})") {
  return error_of([&] { with_camera(camera, node); });
}
const std::string perspective =
    R"({"type": "perspective", "name": "eye", "perspective": {"yfov": 1, "aspectRatio": 2, "znear": 1}})";

TEST(GltfCameras, Perspective) {
  const SceneGraph graph = with_camera(perspective, R"({"camera": 0, "translation": [1, 2, 3], "scale": [9, 9, 9]})");
  const Camera& c = graph.cameras().at(0);
  EXPECT_EQ(c.name, "eye");
  EXPECT_EQ(c.resolution, Vec2i(1024, 512));
  const auto& p = std::get<Perspective>(c.projection);
  EXPECT_NEAR(p.half_height, std::tan(0.5f), 1e-6f);
  EXPECT_NEAR(p.half_width, 2 * std::tan(0.5f), 1e-6f);
  const Ray ray = c.ray(Vec2(512, 256)).ray;
  expect_near(ray.origin, {1, 2, 3});
  expect_near(ray.direction, {0, 0, -1});
}

TEST(GltfCameras, Orthographic) {
  const SceneGraph graph =
      with_camera(R"({"type": "orthographic", "orthographic": {"xmag": -3, "ymag": 1.5, "znear": 0, "zfar": 1}})");
  const auto& p = std::get<Orthographic>(graph.cameras().at(0).projection);
  EXPECT_EQ(p.half_width, 3);
  EXPECT_EQ(p.half_height, 1.5f);
  EXPECT_EQ(graph.cameras()[0].resolution, Vec2i(1024, 512));
}

TEST(GltfCameras, ImpossibleCamerasAreRefused) {
  EXPECT_NE(refused(R"({"type": "perspective", "perspective": {"yfov": 0}})")
                .find("/cameras/0/perspective/yfov: expected more than 0"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type": "perspective", "perspective": {"yfov": 4}})").find("less than pi"), std::string::npos);
  EXPECT_NE(refused(R"({"type": "perspective"})").find("/cameras/0/perspective/yfov: expected a number, found nothing"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": -1}})").find("aspectRatio"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 1}})").find("other than 0"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type": "orthografic"})").find("did you mean 'orthographic'"), std::string::npos);
  EXPECT_NE(refused(perspective, R"({"camera": 0, "scale": [0, 1, 1]})").find("shrinks this camera"),
            std::string::npos);
  EXPECT_NE(refused(perspective, R"({"camera": 1})").find("/nodes/0/camera: refers to 1 of cameras"),
            std::string::npos);
}

TEST(GltfCameras, VeryWideImagesAreLimited) {
  const SceneGraph graph = with_camera(R"({"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 1e30}})");
  EXPECT_EQ(graph.cameras().at(0).resolution.x, 16384);
}

}  // namespace
}  // namespace lambert::gltf
