#include "damage.h"
#include "lambert/image/image_test_tools.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledRgbaFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <ranges>

#include "temporary_folder.h"

namespace lambert {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

Image round_trip(const Image& image) { return decode_exr(encode_exr(image), "a.exr"); }

TEST(Exr, LayersComeBackByName) {
  const std::vector<std::string> names = {"R",        "G",        "B",        "A",          "Z",
                                          "albedo.R", "normal.X", "normal.Z", "position.X", "CryptoObject00.R"};
  Image image = noise(7, 5, names, 100);
  image.metadata = {{"software", "Lambert"}, {"seed", "42"}};
  const Image back = round_trip(image);
  EXPECT_EQ(back.metadata, image.metadata);
  ASSERT_EQ(back.width(), 7);
  ASSERT_EQ(back.height(), 5);
  ASSERT_EQ(back.channel_count(), names.size());
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(back.channels()[c], names[c]) << "the colour first";
  for (std::size_t c = 0; c < names.size(); ++c) {
    const bool precise = names[c] == "Z" || names[c] == "position.X" || names[c] == "CryptoObject00.R";
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) {
        const float v = image.at(x, y, c);
        EXPECT_NEAR(back.at(x, y, *back.channel(names[c])), v, precise ? 0 : v / 2048) << names[c];
      }
    }
  }
}

TEST(Exr, KeepsWhatIsNotFinite) {
  Image image(4, 1, {"R", "Z"});
  const std::array values = {inf, -inf, nan, 1e9f};
  for (int x = 0; x < 4; ++x) image.at(x, 0, 0) = image.at(x, 0, 1) = values[static_cast<std::size_t>(x)];
  const Image back = round_trip(image);
  for (int x = 0; x < 3; ++x) {
    EXPECT_TRUE(same(back.at(x, 0, 0), values[static_cast<std::size_t>(x)])) << x;
    EXPECT_TRUE(same(back.at(x, 0, 1), values[static_cast<std::size_t>(x)])) << x;
  }
  EXPECT_EQ(back.at(3, 0, 0), 1e9f) << "no sun is cut";
  EXPECT_EQ(back.at(3, 0, 1), 1e9f);
  const Image halves = decode_exr(encode_exr(image, {.depth = Depth::half}), "halves.exr");
  EXPECT_EQ(halves.at(3, 0, 0), 65504) << "the largest half";
}

TEST(Exr, GreyWithAlphaStaysGrey) {
  Image image(1, 1, {"Y", "A"});
  image.at(0, 0, 0) = 0.25f, image.at(0, 0, 1) = 0.5f;
  EXPECT_EQ(round_trip(image).channels(), image.channels());
  EXPECT_EQ(round_trip(image).rgb(0, 0), Rgb(0.25f));
}

// rows: LF-20
// Six bytes for R, G and B, whose codes are those of IEEE 754 binary16, compressed without loss.
TEST(Exr, StoresHalves) {
  const std::array values = {1.0f, -2.0f, 65504.0f, 0.1f, 5.96046447754e-08f};
  const std::array<std::uint16_t, 5> codes = {0x3c00, 0xc000, 0x7bff, 0x2e66, 0x0001};
  Image image(5, 1, rgb_channels());
  for (int x = 0; x < 5; ++x) image.set_rgb(x, 0, Rgb(values[static_cast<std::size_t>(x)]));
  const TemporaryFolder folder;
  Imf::InputFile file(folder.write("a.exr", text_of(encode_exr(image))).c_str());
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  Imf::FrameBuffer frame;
  std::array<std::array<std::uint16_t, 5>, 3> stored{};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(file.header().channels()[rgb_channels()[c]].type, Imf::HALF);
    frame.insert(rgb_channels()[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(stored[c].data()), 2, 10));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0);
  for (const auto& channel : stored) EXPECT_EQ(channel, codes);
}

/// One float channel "Y" whose value at (x, y) is 100 y + x + 1.
std::string with_windows(const Imath::Box2i& display, const Imath::Box2i& data) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  {
    Imf::Header header(display, data);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    const int width = data.max.x - data.min.x + 1;
    std::vector<float> row(static_cast<std::size_t>(width));
    Imf::OutputFile file(path.c_str(), header);
    for (int y = data.min.y; y <= data.max.y; ++y) {
      for (int x = 0; x < width; ++x)
        row[static_cast<std::size_t>(x)] = static_cast<float>(100 * y + data.min.x + x + 1);
      Imf::FrameBuffer frame;
      frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() - data.min.x), 4, 0));
      file.setFrameBuffer(frame);
      file.writePixels(1);
    }
  }
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Exr, WindowsAreKeptAndShown) {
  const Imath::Box2i display({10, 20}, {15, 24});
  for (const Imath::Box2i& data :
       {display, Imath::Box2i({12, 21}, {13, 22}), Imath::Box2i({8, 18}, {20, 30}), Imath::Box2i({14, 23}, {30, 40}),
        Imath::Box2i({40, 40}, {41, 41}), Imath::Box2i({-7, -9}, {-2, -1})}) {
    const Image image = decode_exr(bytes_of(with_windows(display, data)), "a.exr");
    EXPECT_EQ(image.display_window(), (Window{10, 20, 6, 5}));
    EXPECT_EQ(image.data_window(),
              (Window{data.min.x, data.min.y, data.max.x - data.min.x + 1, data.max.y - data.min.y + 1}));
    EXPECT_EQ(image.at(0, 0, 0), static_cast<float>(100 * data.min.y + data.min.x + 1));
    const Image back = decode_exr(encode_exr(image, {.depth = Depth::full}), "b.exr");
    EXPECT_EQ(back.display_window(), image.display_window());
    EXPECT_EQ(back.data_window(), image.data_window());
    EXPECT_TRUE(std::ranges::equal(back.pixels(), image.pixels()));
    const Image shown = displayed(image);
    ASSERT_EQ(shown.width(), 6);
    ASSERT_EQ(shown.height(), 5);
    for (int y = 20; y <= 24; ++y) {
      for (int x = 10; x <= 15; ++x) {
        const float expected = data.intersects(Imath::V2i(x, y)) ? static_cast<float>(100 * y + x + 1) : 0;
        EXPECT_EQ(shown.at(x - 10, y - 20, 0), expected) << x << " " << y;
      }
    }
  }
}

TEST(Exr, EveryCompressionAndDepth) {
  Image image(70, 40, {"R", "G", "B", "A", "Z"});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 70; ++x)
      for (std::size_t c = 0; c < 5; ++c)
        image.at(x, y, c) = static_cast<float>(half(0.01f * static_cast<float>(x + y) + static_cast<float>(c)));
  using enum Compression;
  for (const Compression compression : {none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab})
    for (const Depth depth : {Depth::automatic, Depth::half, Depth::full}) {
      const bool lossy = compression >= b44;
      const Image back = decode_exr(encode_exr(image, {.depth = depth, .compression = compression}), "a.exr");
      for (std::size_t i = 0; i < image.pixels().size(); ++i)
        ASSERT_NEAR(back.pixels()[i], image.pixels()[i], lossy ? 0.05f : 0) << static_cast<int>(compression);
    }
}

TEST(Exr, FullDepthKeepsAllDigits) {
  const Image image = noise(5, 5, rgb_channels(), 1e9f);
  const Image back = decode_exr(encode_exr(image, {.depth = Depth::full}), "a.exr");
  EXPECT_TRUE(std::ranges::equal(back.pixels(), image.pixels()));
  EXPECT_NE(error_of([&] { encode_exr(image, {.depth = Depth::bits8}); }), "");
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Every pixel reads the same row, which lives long enough and starts at `left`.
Imf::Slice row_slice(const std::vector<float>& row, int left, int sampling = 1) {
  char* base = const_cast<char*>(reinterpret_cast<const char*>(row.data())) - 4 * (left / sampling);
  return {Imf::FLOAT, base, 4, 0, sampling, sampling};
}

struct PartOf {
  std::string name;
  Imath::Box2i data;
  std::vector<std::string> channels;
};
/// Every channel of part p is p + 1.
std::string with_parts(const std::vector<PartOf>& parts) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  std::vector<Imf::Header> headers;
  for (const PartOf& p : parts) {
    Imf::Header& h = headers.emplace_back(Imath::Box2i({0, 0}, {3, 3}), p.data);
    h.setName(p.name);
    h.setType(Imf::SCANLINEIMAGE);
    for (const std::string& c : p.channels) h.channels().insert(c, Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::vector<float> row(16, static_cast<float>(i + 1));
      Imf::FrameBuffer frame;
      for (const std::string& c : parts[i].channels) frame.insert(c, row_slice(row, parts[i].data.min.x));
      Imf::OutputPart part(file, static_cast<int>(i));
      part.setFrameBuffer(frame);
      part.writePixels(parts[i].data.max.y - parts[i].data.min.y + 1);
    }
  }
  return contents(path);
}

TEST(Exr, PartsBecomeLayersOnOneWindow) {
  const Imath::Box2i all({0, 0}, {3, 3});
  const std::string file = with_parts({{"depth", all, {"Z"}},
                                       {"diffuse", Imath::Box2i({-1, 2}, {1, 4}), {"R", "G", "B"}},
                                       {"RGBA", all, {"R", "G", "B", "A"}},
                                       {"spec", all, {"spec.R", "other.X"}}});
  const Image image = decode_exr(bytes_of(file), "a.exr");
  EXPECT_EQ(image.channels(), (std::vector<std::string>{"R", "G", "B", "A", "depth.Z", "diffuse.B", "diffuse.G",
                                                        "diffuse.R", "spec.other.X", "spec.R"}));
  EXPECT_EQ(image.data_window(), (Window{-1, 0, 5, 5}));
  EXPECT_EQ(image.display_window(), (Window{0, 0, 4, 4}));
  const auto at = [&](const char* channel, int x, int y) { return image.at(x + 1, y, *image.channel(channel)); };
  EXPECT_EQ(at("R", 0, 0), 3);
  EXPECT_EQ(at("R", -1, 0), 0) << "outside of its part's window";
  EXPECT_EQ(at("diffuse.R", -1, 2), 2);
  EXPECT_EQ(at("diffuse.R", 1, 4), 2);
  EXPECT_EQ(at("diffuse.R", 2, 2), 0);
  EXPECT_EQ(at("depth.Z", 3, 3), 1);
}

TEST(Exr, DeepFilesAreRefusedWithTheReason) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  {
    Imf::Header h(2, 2);
    h.setType(Imf::DEEPSCANLINE);
    h.compression() = Imf::ZIPS_COMPRESSION;
    h.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    Imf::DeepScanLineOutputFile file(path.c_str(), h);
    std::array<unsigned, 4> counts{};
    std::array<float*, 4> samples{};
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), 4, 8));
    frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), 8, 16, 4));
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  const std::string message = error_of([&] { decode_exr(bytes_of(contents(path)), "a.exr"); });
  EXPECT_EQ(message.rfind("a.exr: part 0 is deep", 0), 0u) << message;
}

TEST(Exr, LuminanceAndChromaBecomeColours) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  std::vector<Imf::Rgba> pixels(32 * 16, Imf::Rgba(0.25f, 0.5f, 1.0f, 0.75f));
  {
    Imf::RgbaOutputFile file(path.c_str(), 32, 16, Imf::WRITE_YCA);
    file.setFrameBuffer(pixels.data(), 1, 32);
    file.writePixels(16);
  }
  const Image image = decode_exr(bytes_of(contents(path)), "a.exr");
  ASSERT_EQ(image.channels(), rgba_channels());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      EXPECT_NEAR(image.at(x, y, 0), 0.25f, 5e-3f);
      EXPECT_NEAR(image.at(x, y, 1), 0.5f, 5e-3f);
      EXPECT_NEAR(image.at(x, y, 2), 1, 5e-3f);
      EXPECT_EQ(image.at(x, y, 3), 0.75f);
    }
}

/// Channels "Y" of every pixel and the others at every `sampling`-th: all of the value that `of` gives them.
std::string subsampled(const std::map<std::string, float>& channels, int sampling) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  Imf::Header h(Imath::Box2i({0, 0}, {11, 8}), Imath::Box2i({-3, -3}, {8, 5}));
  std::map<std::string, std::vector<float>> rows;
  Imf::FrameBuffer frame;
  for (const auto& [name, value] : channels) {
    const int s = name == "Y" ? 1 : sampling;
    h.channels().insert(name, Imf::Channel(Imf::FLOAT, s, s));
    rows[name].assign(16, value);
    frame.insert(name, row_slice(rows[name], -3, s));
  }
  {
    Imf::OutputFile file(path.c_str(), h);
    file.setFrameBuffer(frame);
    file.writePixels(9);
  }
  return contents(path);
}

TEST(Exr, OtherSamplingsAreRepeated) {
  for (const int sampling : {1, 3}) {
    const Image grey = decode_exr(bytes_of(subsampled({{"Y", 0.5f}, {"id", 7}}, sampling)), "a.exr");
    ASSERT_EQ(grey.channels(), (std::vector<std::string>{"Y", "id"}));
    EXPECT_TRUE(std::ranges::all_of(std::views::iota(0, 12 * 9), [&](int i) {
      return grey.at(i % 12, i / 12, 0) == 0.5f && grey.at(i % 12, i / 12, 1) == 7;
    })) << sampling;
    const Image colour = decode_exr(bytes_of(subsampled({{"Y", 0.5f}, {"RY", 1}, {"BY", -0.5f}}, sampling)), "a.exr");
    ASSERT_EQ(colour.channels(), rgb_channels());
    for (int i = 0; i < 12 * 9; ++i) {
      const Rgb c = colour.rgb(i % 12, i / 12);
      ASSERT_EQ(c.r, 1);
      ASSERT_EQ(c.b, 0.25f);
      ASSERT_NEAR(luminance(c), 0.5f, 1e-3f);
    }
  }
}

TEST(Exr, PrimariesBecomeRec709) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  const auto read_with = [&](const Imf::Chromaticities& c, const std::string& layer) {
    Imf::Header h(1, 1);
    Imf::addChromaticities(h, c);
    std::array<float, 3> values{0.9505f, 1, 1.089f};
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name = layer + rgb_channels()[i];
      h.channels().insert(name, Imf::Channel(Imf::FLOAT));
      frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[i]), 4, 0));
    }
    {
      Imf::OutputFile file(path.c_str(), h);
      file.setFrameBuffer(frame);
      file.writePixels(1);
    }
    return decode_exr(bytes_of(contents(path)), "a.exr");
  };
  const Imf::Chromaticities xyz({1, 0}, {0, 1}, {0, 0}, {1 / 3.0f, 1 / 3.0f});
  for (const std::string layer : {"", "sun."}) {
    const Image image = read_with(xyz, layer);
    for (const char* c : {"R", "G", "B"}) EXPECT_NEAR(image.at(0, 0, *image.channel(layer + c)), 1, 1e-3f);
    EXPECT_EQ(image.attributes.at("chromaticities").value, "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329");
  }
  EXPECT_EQ(read_with({}, "").at(0, 0, 0), 0.9505f) << "Rec. 709 stays bit for bit";
  EXPECT_EQ(read_with(xyz, "CryptoObject00.").at(0, 0, 2), 0.9505f) << "ids are no colours";
  EXPECT_EQ(error_of([&] { read_with({{0, 0}, {0, 0}, {0, 0}, {0, 0}}, ""); }).rfind("a.exr: ", 0), 0u);
}

TEST(Exr, TiledFilesOfManyLevelsAreReadAtTheFinest) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  for (const Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
    std::vector<Imf::Rgba> pixels;
    for (int i = 0; i < 40 * 30; ++i) pixels.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
    {
      Imf::TiledRgbaOutputFile file(path.c_str(), 40, 30, 16, 8, mode, Imf::ROUND_DOWN, Imf::WRITE_RGB);
      file.setFrameBuffer(pixels.data(), 1, 40);
      for (int ly = 0; ly < file.numYLevels(); ++ly)
        for (int lx = 0; lx < file.numXLevels(); ++lx)
          if (file.isValidLevel(lx, ly)) file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
    }
    const Image image = decode_exr(bytes_of(contents(path)), "a.exr");
    ASSERT_EQ(image.width(), 40);
    ASSERT_EQ(image.height(), 30);
    for (int i = 0; i < 1200; ++i) ASSERT_EQ(image.at(i % 40, i / 40, 0), static_cast<float>(i));
  }
}

TEST(Exr, AttributesComeBack) {
  Image image = noise(2, 2, rgb_channels());
  image.metadata["comments"] = "hello";
  image.attributes = {{"framesPerSecond", {"rational", "24000 1001"}},
                      {"timeCode", {"timecode", "19088743 0"}},
                      {"keyCode", {"keycode", "1 2 3 4 5 1 24"}},
                      {"envmap", {"envmap", "cube"}},
                      {"expTime", {"float", "0.008"}},
                      {"count", {"int", "-3"}},
                      {"exact", {"double", "0.1"}},
                      {"place", {"v2f", "0.5 inf"}},
                      {"size", {"v3i", "1 2 3"}},
                      {"worldToCamera", {"m44f", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"}},
                      {"crop", {"box2i", "1 2 3 4"}},
                      {"multiView", {"stringvector", "left right\\ eye \\0 back\\\\slash"}},
                      {"weights", {"floatvector", "0.25 0.5 1"}},
                      {"pixelAspectRatio", {"float", "2"}},
                      {"whiteLuminance", {"float", "100"}},
                      {"secret", {"ownType", "00ff10"}}};
  const Image back = decode_exr(encode_exr(image), "a.exr");
  EXPECT_EQ(back.metadata, image.metadata);
  for (const auto& [name, a] : image.attributes) {
    ASSERT_TRUE(back.attributes.contains(name)) << name;
    EXPECT_EQ(back.attributes.at(name), a) << name << ": " << back.attributes.at(name).value;
  }
  EXPECT_EQ(back.attributes.size(), image.attributes.size());
  for (const Attribute& wrong : {Attribute{"float", "x"},
                                 {"float", "1 2"},
                                 {"v2f", "1"},
                                 {"envmap", "ball"},
                                 {"int", "1.5"},
                                 {"int", "3000000000"},
                                 {"ownType", "0g"},
                                 {"ownType", "0"}}) {
    image.attributes = {{"wrong", wrong}};
    EXPECT_NE(error_of([&] { encode_exr(image); }).find("'wrong'"), std::string::npos) << wrong.value;
  }
}

TEST(Exr, ErrorsOfLengthNameTheFile) {
  const std::string whole = text_of(encode_exr(noise(20, 20, rgb_channels())));
  for (const std::size_t length : {std::size_t{5}, std::size_t{100}, whole.size() - 1}) {
    const std::string message = error_of([&] { decode_exr(bytes_of(whole).subspan(0, length), "a.exr"); });
    EXPECT_EQ(message.rfind("a.exr: ", 0), 0u) << message;
  }
}

}  // namespace
}  // namespace lambert
