#include "lambert/base/file.h"
#include "lambert/formats/format_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

namespace lambert {
namespace {

TriangleMesh read(const std::string& data, Notes& notes) {
  return read_ply(std::as_bytes(std::span(data.data(), data.size())), "m.ply", notes);
}
TriangleMesh read(const std::string& data) {
  Notes notes;
  return read(data, notes);
}

const std::string square_header =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ascii_square =
    "ply\nformat ascii 1.0\ncomment made by hand\n" + square_header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// Appends values in little or big endian order.
struct Bytes {
  bool big = false;
  std::string out = {};
  template <class T>
  Bytes& add(T v) {
    char b[sizeof v];
    std::memcpy(b, &v, sizeof v);
    if (big) std::reverse(b, b + sizeof v);
    out.append(b, sizeof v);
    return *this;
  }
};

TEST(Ply, AsciiQuadBecomesTwoTriangles) {
  const TriangleMesh m = read(ascii_square);
  ASSERT_EQ(m.positions.size(), 4u);
  EXPECT_EQ(m.positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(m.triangles.size(), 2u);
  EXPECT_NEAR(m.area(), 1, 1e-6f);
}

TEST(Ply, BothByteOrdersAgree) {
  for (const bool big : {false, true}) {
    Bytes b{big};
    for (const int v : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) b.add(static_cast<float>(v));
    b.add(std::uint8_t{4});
    for (const int i : {0, 1, 2, 3}) b.add(i);
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const TriangleMesh m = read("ply\nformat " + format + " 1.0\n" + square_header + b.out);
    EXPECT_EQ(m.positions, read(ascii_square).positions);
    EXPECT_EQ(m.triangles, read(ascii_square).triangles);
  }
}

TEST(Ply, AllAttributesAndOddTypes) {
  const std::string header =
      "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 3\r\nproperty double x\r\nproperty short y\r\n"
      "property int8 z\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\nproperty float s\r\n"
      "property float t\r\nproperty uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\nproperty float "
      "quality\r\n"
      "element face 1\r\nproperty uchar flags\r\nproperty list ushort uint16 vertex_index\r\nend_header\r\n";
  Bytes b;
  for (int i = 0; i < 3; ++i) {
    b.add(0.5 * i).add(static_cast<std::int16_t>(i == 1 ? 300 : 0)).add(static_cast<std::int8_t>(-1));
    b.add(0.0f).add(0.0f).add(1.0f).add(0.25f).add(0.75f);
    b.add(std::uint8_t{255}).add(std::uint8_t{0}).add(std::uint8_t{128}).add(9.0f);
  }
  b.add(std::uint8_t{7}).add(std::uint16_t{3}).add(std::uint16_t{0}).add(std::uint16_t{1}).add(std::uint16_t{2});
  Notes notes;
  const TriangleMesh m = read(header + b.out, notes);
  EXPECT_EQ(m.positions[1], Vec3(0.5f, 300, -1));
  EXPECT_EQ(m.normals[2], Vec3(0, 0, 1));
  EXPECT_EQ(m.uvs[0], Vec2(0.25f, 0.75f));
  EXPECT_EQ(m.colours[0].x, 1.0f);
  EXPECT_NEAR(m.colours[0].z, 0.2159f, 1e-3f) << "bytes are sRGB";
  EXPECT_EQ(m.colours[0].w, 1.0f);
  EXPECT_TRUE(has_note(notes, "'quality'"));
  EXPECT_TRUE(has_note(notes, "'flags'"));
}

TEST(Ply, MixedPolygonsAndFacesBeforeVertices) {
  const TriangleMesh m = read(
      "ply\nformat ascii 1.0\nelement face 3\nproperty list int int vertex_indices\nelement vertex 5\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n"
      "3 0 1 2\n5 0 1 2 3 4\n2 0 1\n0 0 0 2 0 0 2 1 0 1 2 0 0 1 0\n");
  EXPECT_EQ(m.triangles.size(), 4u);
}

TEST(Ply, TriangleStrips) {
  const TriangleMesh m = read(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  const std::vector<Triangle> expected{{0, 1, 2}, {2, 1, 3}, {0, 1, 2}};
  EXPECT_EQ(m.triangles, expected);
}

TEST(Ply, LyingHeadersAreRefusedBeforeAnythingIsAllocated) {
  std::string text = ascii_square;
  text.replace(text.find("vertex 4"), 8, "vertex 4000000000");
  EXPECT_NE(error_of([&] { read(text); }).find("m.ply:4:1: promises 4000000000 'vertex' elements"), std::string::npos);
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\n";
  EXPECT_NE(error_of([&] { read(binary + "property float x\nend_header\n"); }).find("m.ply:3:16:"), std::string::npos);
  EXPECT_NE(error_of([] {
              read(
                  "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000\nproperty double x\n"
                  "property double y\nproperty double z\nend_header\nabc");
            }).find("only 3 bytes are left"),
            std::string::npos);
}

TEST(Ply, LyingListsAreRefused) {
  Bytes b;
  for (int i = 0; i < 12; ++i) b.add(static_cast<float>(i));
  b.add(std::uint32_t{4000000000u});
  std::string header = square_header;
  header.replace(header.find("uchar int"), 9, "uint int");
  const std::string message = error_of([&] { read("ply\nformat binary_little_endian 1.0\n" + header + b.out); });
  EXPECT_NE(message.find("ends too early"), std::string::npos) << message;
}

TEST(Ply, ErrorsSayWhere) {
  std::string text = ascii_square;
  text.replace(text.find("1 1 0"), 5, "1 x 0");
  EXPECT_EQ(error_of([&] { read(text); }), "m.ply:13:3: expected a finite number, found 'x'");
  text = ascii_square;
  text.replace(text.find("2 3\n"), 4, "2 9\n");
  EXPECT_EQ(error_of([&] { read(text); }), "m.ply:15:9: face 0: there is no vertex 9");
  EXPECT_EQ(error_of([] { read("plx\n"); }), "m.ply:1:1: not a PLY file: the first line must be 'ply'");
  EXPECT_NE(error_of([] {
              read("ply\nformat ascii 1.0\nelement vertex 1\nproperty flaot x\n");
            }).find("m.ply:4:10: unknown type 'flaot'; did you mean 'float'?"),
            std::string::npos);
}

TEST(Ply, NotFiniteVerticesAreNamed) {
  Bytes b;
  for (int i = 0; i < 12; ++i) b.add(i == 7 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i));
  b.add(std::uint8_t{4});
  for (const int i : {0, 1, 2, 3}) b.add(i);
  EXPECT_EQ(error_of([&] { read("ply\nformat binary_little_endian 1.0\n" + square_header + b.out); }),
            "m.ply: vertex 2: its position is not finite");
}

std::string big_binary_ply(int side) {
  const int vertices = (side + 1) * (side + 1), faces = 2 * side * side;
  Bytes b;
  b.out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
          "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < vertices; ++i) {
    b.add(static_cast<float>(i % (side + 1))).add(static_cast<float>(i / (side + 1))).add(0.0f);
  }
  for (int i = 0; i < side * side; ++i) {
    const int v = i / side * (side + 1) + i % side;
    b.add(std::uint8_t{3}).add(v).add(v + 1).add(v + side + 1);
    b.add(std::uint8_t{3}).add(v + 1).add(v + side + 2).add(v + side + 1);
  }
  return b.out;
}

TEST(Ply, AMillionTrianglesReadFast) {
  const std::string data = big_binary_ply(708);
  const auto start = std::chrono::steady_clock::now();
  const TriangleMesh m = read(data);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(m.triangles.size(), 2u * 708 * 708);
  EXPECT_NEAR(m.area(), 708.0f * 708.0f, 708.0f);
  RecordProperty("seconds", std::to_string(elapsed.count()));
#ifdef NDEBUG
  EXPECT_LT(elapsed.count(), 2.0) << "usually a twentieth of this; the bound allows for a busy machine";
#endif
}

TEST(Ply, AWrongIndexAmongManyIsNamed) {
  std::string data = big_binary_ply(300);
  const std::size_t row = 13, at = data.size() - row * 5 + 1;
  const int wrong = 1 << 30;
  std::memcpy(&data[at], &wrong, sizeof wrong);
  EXPECT_EQ(error_of([&] { read(data); }),
            "m.ply: face " + std::to_string(2 * 300 * 300 - 5) + ": names a vertex that does not exist");
}

TEST(Ply, SurvivesDamage) {
  expect_survives_damage(ascii_square, 500, [](const std::string& text) { read(text); });
  expect_survives_damage(big_binary_ply(6), 500, [](const std::string& text) { read(text); });
}

TEST(Ply, ReadsFilesOfOtherPrograms) {
  const std::filesystem::path folder = std::filesystem::path(LAMBERT_SHARED_DATA) / "scenes/luxcore";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "needs " << folder;
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".ply") continue;
    const MappedFile file(entry.path());
    Notes notes;
    const TriangleMesh m = read_ply(file.bytes(), entry.path().string(), notes);
    EXPECT_GT(m.triangles.size(), 0u);
    EXPECT_NO_THROW(validate(m));
    ++files;
  }
  EXPECT_GE(files, 15);
}

}  // namespace
}  // namespace lambert
