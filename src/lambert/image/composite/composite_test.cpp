#include "lambert/image/composite/composite.h"

#include "lambert/base/error.h"
#include "lambert/image/composite/porter_duff.h"
#include "lambert/image/composite/sequence.h"
#include "lambert/image/image_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "temporary_folder.h"

namespace lambert::composite {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

/// One colour in a rectangle of the plane.
Image patch(const Window& at, const Window& display, Pixel p, std::vector<std::string> channels = rgba_channels()) {
  Image image(at.width, at.height, channels);
  image.place({at.x, at.y}, display);
  const std::array<float, 4> values{p.r, p.g, p.b, p.a};
  for (std::size_t i = 0; i < image.pixels().size(); ++i) image.pixels()[i] = values[i % channels.size()];
  return image;
}

Pixel pixel_at(const Image& image, int x, int y) {
  const Window w = image.data_window();
  const auto value = [&](const char* name) { return image.at(x - w.x, y - w.y, *image.channel(name)); };
  return {value("R"), value("G"), value("B"), image.channel("A") ? value("A") : 1};
}

struct Plane : ::testing::Test {
  Pictures pictures;
  Image eval(const std::string& text, int frame = 1) {
    CompositeSettings settings{.frame = frame, .text = text};
    return composite(parse_expression(text), pictures, settings);
  }
  Image generated(const std::string& text, int width, int height) {
    const CompositeSettings settings{.display = Window{0, 0, width, height}, .text = text};
    return composite(parse_expression(text), pictures, settings);
  }
};

// rows: AA-26 AA-29
TEST_F(Plane, WindowsUnite) {
  pictures.add("a.exr", patch({-3, 2, 5, 4}, {0, 0, 20, 10}, {0.25f, 0, 0, 0.5f}));
  pictures.add("b.exr", patch({1, 4, 6, 5}, {0, 0, 30, 12}, {0, 0, 1, 1}));
  const Image over = eval("a.exr over b.exr");
  EXPECT_EQ(over.data_window(), (Window{-3, 2, 10, 7}));
  EXPECT_EQ(over.display_window(), (Window{0, 0, 30, 12})) << "the background's";
  EXPECT_EQ(pixel_at(over, -3, 2), (Pixel{0.25f, 0, 0, 0.5f}));
  EXPECT_EQ(pixel_at(over, 1, 4), (Pixel{0.25f, 0, 0.5f, 1}));
  EXPECT_EQ(pixel_at(over, 6, 8), (Pixel{0, 0, 1, 1}));
  EXPECT_EQ(pixel_at(over, 6, 2), clear_pixel);
  EXPECT_EQ(pixel_at(eval("a.exr in b.exr"), 6, 8), clear_pixel);
  EXPECT_EQ(pixel_at(eval("a.exr out b.exr"), -3, 2), (Pixel{0.25f, 0, 0, 0.5f}));
}

TEST_F(Plane, ApartAndOneByOne) {
  pictures.add("a.exr", patch({0, 0, 1, 1}, {0, 0, 1, 1}, {1, 0, 0, 1}));
  pictures.add("b.exr", patch({9, 3, 1, 1}, {9, 3, 1, 1}, {0, 1, 0, 1}));
  const Image over = eval("a.exr over b.exr");
  EXPECT_EQ(over.data_window(), (Window{0, 0, 10, 4}));
  EXPECT_EQ(pixel_at(over, 0, 0), (Pixel{1, 0, 0, 1}));
  EXPECT_EQ(pixel_at(over, 9, 3), (Pixel{0, 1, 0, 1}));
  EXPECT_EQ(pixel_at(over, 5, 1), clear_pixel);
}

TEST_F(Plane, MissingAlphaIsOneAndGreyIsThreeColours) {
  pictures.add("rgb.exr", patch({0, 0, 2, 2}, {0, 0, 2, 2}, {0.1f, 0.2f, 0.3f}, rgb_channels()));
  pictures.add("grey.exr", patch({0, 0, 2, 2}, {0, 0, 2, 2}, {0.25f, 0, 0}, {"Y"}));
  pictures.add("fg.exr", patch({0, 0, 1, 1}, {0, 0, 2, 2}, {0.5f, 0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(pixel_at(eval("fg.exr over grey.exr"), 0, 0), (Pixel{0.625f, 0.625f, 0.625f, 1}));
  EXPECT_EQ(pixel_at(eval("rgb.exr over grey.exr"), 1, 1), (Pixel{0.1f, 0.2f, 0.3f, 1}));
  EXPECT_EQ(eval("rgb.exr exposure 1").channels(), rgb_channels());
  EXPECT_EQ(pixel_at(eval("fg.exr mask grey.exr"), 0, 0), (Pixel{0.125f, 0.125f, 0.125f, 0.125f})) << "by luminance";
  EXPECT_EQ(pixel_at(eval("rgb.exr mask fg.exr"), 0, 0).a, 0.5f) << "by alpha";
  EXPECT_EQ(pixel_at(eval("rgb.exr stencil fg.exr"), 1, 1).a, 1);
}

// rows: AA-26
TEST_F(Plane, TheNearerLiesOver) {
  const auto element = [](Pixel p, float z) {
    Image image(1, 1, {"R", "G", "B", "A", "Z"});
    const std::array<float, 5> values{p.r, p.g, p.b, p.a, z};
    std::ranges::copy(values, image.pixels().begin());
    return image;
  };
  pictures.add("near.exr", element({0.5f, 0, 0, 0.5f}, 2));
  pictures.add("far.exr", element({0, 1, 0, 1}, 5));
  pictures.add("same.exr", element({0, 0, 1, 1}, 5));
  pictures.add("none.exr", element({}, 0));
  pictures.add("flat.exr", patch({0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}));
  const auto z = [](const Image& image) { return image.at(0, 0, *image.channel("Z")); };
  for (const char* text : {"near.exr zover far.exr", "far.exr zover near.exr"}) {
    EXPECT_EQ(pixel_at(eval(text), 0, 0), (Pixel{0.5f, 0.5f, 0, 1})) << text;
    EXPECT_EQ(z(eval(text)), 2);
  }
  EXPECT_EQ(pixel_at(eval("far.exr zover same.exr"), 0, 0), (Pixel{0, 1, 0, 1})) << "of equals the first";
  EXPECT_EQ(pixel_at(eval("same.exr zover far.exr"), 0, 0), (Pixel{0, 0, 1, 1}));
  EXPECT_EQ(z(eval("none.exr zover far.exr")), 5) << "what covers nothing is nowhere";
  EXPECT_EQ(pixel_at(eval("flat.exr zover far.exr"), 0, 0), (Pixel{0, 1, 0, 1})) << "without Z: infinitely far";
  EXPECT_EQ(z(eval("near.exr over far.exr")), 2);
  EXPECT_EQ(z(eval("none.exr over far.exr")), 5);
  EXPECT_EQ(z(eval("far.exr out far.exr")), inf);
  EXPECT_EQ(pixel_at(eval("near.exr depth-matte 1 5"), 0, 0).a, 0.25f);
  pictures.add("unseen.exr", element({1, 0, 0, 1}, 0));
  EXPECT_EQ(pixel_at(eval("unseen.exr zover far.exr"), 0, 0), (Pixel{0, 1, 0, 1})) << "Z is 0";
  EXPECT_EQ(pixel_at(eval("unseen.exr depth-matte 1 5"), 0, 0).a, 1);
  EXPECT_EQ(pixel_at(eval("none.exr depth-matte 1 5"), 0, 0).a, 1);
  // Fog that keeps to the element: half covered pixels get half of it.
  EXPECT_EQ(pixel_at(eval("(colour(1,1,1) mask (near.exr depth-matte 1 3)) atop near.exr"), 0, 0),
            (Pixel{0.5f, 0.25f, 0.25f, 0.5f}));
  EXPECT_THROW(eval("flat.exr zover flat.exr"), Error);
}

TEST_F(Plane, LayersFollow) {
  Image a(1, 1, {"R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "object.id"});
  const std::array<float, 8> va{0.5f, 0, 0, 0.5f, 0.25f, 0, 0, 7};
  std::ranges::copy(va, a.pixels().begin());
  Image b(1, 1, {"R", "G", "B", "A", "albedo.R", "object.id"});
  const std::array<float, 6> vb{0, 0, 1, 1, 0.5f, 9};
  std::ranges::copy(vb, b.pixels().begin());
  pictures.add("a.exr", a);
  pictures.add("b.exr", b);
  const Image over = eval("a.exr over b.exr");
  EXPECT_EQ(over.at(0, 0, *over.channel("albedo.R")), 0.5f) << "0.25 + 0.5 0.5";
  EXPECT_EQ(over.at(0, 0, *over.channel("object.id")), 7);
  EXPECT_EQ(pixel_at(eval("a.exr layer albedo"), 0, 0), (Pixel{0.25f, 0, 0, 0.5f}));
  EXPECT_EQ(pixel_at(eval("a.exr channel object.id low=6 high=8"), 0, 0).r, 0.5f);
  EXPECT_THROW(eval("a.exr layer albdeo"), Error);
  EXPECT_THROW(eval("a.exr channel Z"), Error);
}

// rows: AA-07 AA-10
TEST_F(Plane, GeneratorsAreMattes) {
  const Image half = generated("rectangle(0.5, 0, 2, 1.25)", 4, 2);
  EXPECT_EQ(pixel_at(half, 0, 0).a, 0.5f);
  EXPECT_EQ(pixel_at(half, 1, 0).a, 1);
  EXPECT_EQ(pixel_at(half, 2, 1).a, 0.125f);
  const Image triangle = generated("polygon(0,0, 4,0, 0,4)", 4, 4);
  double sum = 0;
  for (const float v : triangle.pixels()) sum += static_cast<double>(v) / 4;
  EXPECT_NEAR(sum, 8, 1e-5);
  EXPECT_NEAR(pixel_at(triangle, 3, 0).a, 0.5f, 1e-6f);
  const Image disk = generated("disk(16, 16, 12)", 32, 32);
  sum = 0;
  for (const float v : disk.pixels()) sum += static_cast<double>(v) / 4;
  EXPECT_NEAR(sum, 144 * 3.14159265, 1.5);
  EXPECT_EQ(pixel_at(generated("gradient(0,0,8,0)", 8, 1), 2, 0).g, 2.5f / 8);
  EXPECT_EQ(pixel_at(generated("disk(16,16,12) invert", 32, 32), 0, 0), (Pixel{1, 1, 1, 1}));
  // What reaches far out of the picture is cut without a trace.
  const Image cut = generated("polygon(-1e6,-1e6, 1e6,-1e6, 1e6,1e6, -1e6,1e6) crop 0 0 3 3", 3, 3);
  for (const float v : cut.pixels()) EXPECT_NEAR(v, 1, 1e-5f);
  EXPECT_THROW(eval("disk(1,1,1)"), Error) << "how large is it?";
}

// A line one pixel high and of slope 0.3 as a thin polygon: each column's coverages add up to 1, and two polygons that
// share an edge cover what they share exactly once.
// rows: AA-07 AA-09 AA-10
TEST_F(Plane, CoverageOfAThinPolygonAddsUp) {
  const Image line = generated("polygon(0,1, 20,7, 20,8, 0,2)", 20, 9);
  const Window w = line.data_window();
  for (int x = 0; x < 20; ++x) {
    float sum = 0;
    for (int y = 0; y < w.height; ++y) sum += line.at(x - w.x, y, 3);
    EXPECT_NEAR(sum, 1, 1e-5f) << "column " << x;
  }
  const Image both = generated("polygon(1,1, 9,2, 8,8) plus polygon(1,1, 8,8, 2,9)", 10, 10),
              whole = generated("polygon(1,1, 9,2, 8,8, 2,9)", 10, 10);
  ASSERT_EQ(both.data_window(), whole.data_window());
  for (std::size_t i = 0; i < both.pixels().size(); ++i) EXPECT_NEAR(both.pixels()[i], whole.pixels()[i], 1e-6f);
}

// A picture of many elements: a glow that hides nothing, a matted subject, a darkened copy as its shadow, a plate.
// rows: AA-31 AA-32
TEST_F(Plane, APictureOfManyElements) {
  const Window frame{0, 0, 5, 4};
  const Image subject = noise(5, 4, rgba_channels()), plate = noise(5, 4, rgb_channels(), 3);
  pictures.add("subject.exr", subject);
  pictures.add("plate.exr", plate);
  pictures.add("matte.exr", patch(frame, frame, {0, 0, 0, 0.75f}));
  const Image image = eval(
      "(subject.exr opaque 0 dissolve 0.5) plus ((subject.exr mask matte.exr) over ((subject.exr darken 0 dissolve 0.6)"
      " over plate.exr))");
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      const Pixel s = pixel_at(subject, x, y), p = pixel_at(plate, x, y);
      const Pixel glow{0.5f * s.r, 0.5f * s.g, 0.5f * s.b, 0}, matted = 0.75f * s, shadow{0, 0, 0, 0.6f * s.a};
      const Pixel behind = shadow + (1 - shadow.a) * p;
      const Pixel expected = glow + (matted + (1 - matted.a) * behind), seen = pixel_at(image, x, y);
      EXPECT_NEAR(seen.r, expected.r, 1e-6f);
      EXPECT_NEAR(seen.g, expected.g, 1e-6f);
      EXPECT_NEAR(seen.b, expected.b, 1e-6f);
      EXPECT_NEAR(seen.a, 1, 1e-6f);
    }
}

TEST_F(Plane, ElementsMove) {
  pictures.add("a.exr", patch({0, 0, 2, 2}, {0, 0, 8, 8}, {1, 1, 1, 1}));
  EXPECT_EQ(eval("a.exr translate 3 -1").data_window(), (Window{3, -1, 2, 2}));
  const Image between = eval("a.exr translate 0.25 0");
  EXPECT_EQ(between.data_window(), (Window{0, 0, 3, 2}));
  EXPECT_EQ(pixel_at(between, 0, 0).a, 0.75f);
  EXPECT_EQ(pixel_at(between, 1, 0).a, 1);
  EXPECT_EQ(pixel_at(between, 2, 0).a, 0.25f);
  EXPECT_EQ(eval("a.exr crop 1 1 5 5").data_window(), (Window{1, 1, 1, 1}));
  EXPECT_EQ(eval("a.exr translate [1:0 11:5] 0", 5).data_window().x, 2) << "keys";
}

/// The tree's picture does not depend on where the bands end: each row alone is what the whole is.
TEST_F(Plane, BandsDoNotShow) {
  pictures.add("a.exr", noise(23, 150, rgba_channels()));
  pictures.add("b.exr", noise(23, 150, rgba_channels()));
  for (const char* text : {"a.exr over b.exr", "(a.exr blur 1.5) over b.exr", "(a.exr erode 2) atop (b.exr dilate 3)",
                           "a.exr edge 1", "a.exr translate 1.5 2.25 xor b.exr", "a.exr blur 3 blur 2"}) {
    const Image whole = eval(text);
    const Window w = whole.data_window();
    for (int y : {0, 63, 64, 65, 127, 128, w.height - 1}) {
      const Image row = eval("(" + std::string(text) + ") crop -50 " + std::to_string(w.y + y) + " 200 1");
      for (int x = 0; x < w.width; ++x)
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR(row.at(x, 0, c), whole.at(x, y, c), 2e-6f) << text << " row " << y;
    }
  }
}

TEST_F(Plane, BlurKeepsTheLightAndErodeKeepsColours) {
  pictures.add("a.exr", patch({4, 4, 9, 9}, {0, 0, 20, 20}, {0.2f, 0.4f, 0.6f, 1}));
  const Image blurred = eval("a.exr blur 2");
  EXPECT_EQ(blurred.data_window(), (Window{-6, -6, 29, 29}));
  double sum = 0;
  for (std::size_t i = 3; i < blurred.pixels().size(); i += 4) sum += static_cast<double>(blurred.pixels()[i]);
  EXPECT_NEAR(sum, 81, 1e-3);
  const Image thin = eval("a.exr erode 2");
  EXPECT_EQ(pixel_at(thin, 5, 8), clear_pixel);
  EXPECT_EQ(pixel_at(thin, 6, 8), (Pixel{0.2f, 0.4f, 0.6f, 1}));
  const Image thick = eval("a.exr dilate 2");
  EXPECT_EQ(pixel_at(thick, 2, 8), (Pixel{0.2f, 0.4f, 0.6f, 1}));
  EXPECT_EQ(pixel_at(eval("a.exr edge 1"), 8, 8), clear_pixel);
  EXPECT_EQ(pixel_at(eval("a.exr edge 1"), 3, 8).r, 1);
  pictures.add("photo.exr", patch({0, 0, 9, 9}, {0, 0, 9, 9}, {0.5f, 0.5f, 0.5f}, rgb_channels()));
  const Image photo = eval("photo.exr blur 2");
  EXPECT_EQ(photo.data_window(), (Window{0, 0, 9, 9}));
  for (const float v : photo.pixels()) EXPECT_NEAR(v, 0.5f, 1e-6f) << "no dark edge";
}

TEST_F(Plane, DeepTreesNeedFewBands) {
  pictures.add("a.exr", patch({0, 0, 40, 200}, {0, 0, 40, 200}, {0.1f, 0.1f, 0.1f, 0.1f}));
  std::string left = "a.exr", right = "a.exr";
  for (int i = 1; i < 250; ++i) left += " over a.exr", right = "a.exr over (" + right + ")";
  const TemporaryFolder folder;
  write_image(folder.path() / "a.exr", patch({0, 0, 40, 200}, {0, 0, 40, 200}, {0.1f, 0.1f, 0.1f, 0.1f}));
  for (const std::string& text : {left, right}) {
    const Image image = eval(text);
    EXPECT_NEAR(pixel_at(image, 3, 100).a, 1, 1e-5f);
    Expression e = parse_expression(text);
    const std::function<void(Expression&)> place = [&](Expression& t) {
      if (!t.word) t.text = (folder.path() / "a.exr").string();
      for (Expression& input : t.inputs) place(input);
    };
    place(e);
    const CompositeReport report = composite_to_files(e, {folder.path() / "out.exr"});
    EXPECT_LE(report.bytes_in_bands, 3u * 64 * 40 * 4 * sizeof(float)) << "two bands and the rows read or written";
  }
}

TEST(CompositeToFiles, StopsBetweenBandsAndWritesNothing) {
  const TemporaryFolder folder;
  std::stop_source source;
  CompositeSettings settings{.display = Window{0, 0, 64, 400}, .stop = source.get_token()};
  settings.progress = [&](double) { source.request_stop(); };
  const CompositeReport report =
      composite_to_files(parse_expression("disk(32,32,20) blur 2"), {folder.path() / "a.exr"}, {}, settings);
  EXPECT_TRUE(report.stopped);
  EXPECT_EQ(report.bands, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CompositeToFiles, FullFloatsStayWhatTheyAre) {
  const TemporaryFolder folder;
  Image image(1, 1, {"R", "G", "B"});
  image.at(0, 0, 0) = 1e6f;
  write_image(folder.path() / "sun.exr", image);
  composite_to_files(parse_expression("'" + (folder.path() / "sun.exr").string() + "' over colour(0,0,0)"),
                     {folder.path() / "a.exr"});
  EXPECT_EQ(read_image(folder.path() / "a.exr").at(0, 0, 0), 1e6f);
}

TEST(Pictures, FilesThatAreDecodedWholeMayBeSpooled) {
  const TemporaryFolder folder;
  const Image image = noise(13, 40, rgb_channels());
  const std::string path = (folder.path() / "a.pfm").string();
  write_image(path, image);
  Pictures spooled(2, 0), kept;
  std::vector<float> a(13 * 3 * 5), b(a.size());
  EXPECT_TRUE(std::ranges::equal(spooled.rows(path, 30, 35, a), kept.rows(path, 30, 35, b)));
  EXPECT_TRUE(std::equal(a.begin(), a.end(), image.row(30).begin()));
}

// rows: AA-33
TEST(Sequence, FramesAndNames) {
  EXPECT_EQ(parse_frames("1-4"), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(parse_frames("1-8x3,20"), (std::vector{1, 4, 7, 20}));
  EXPECT_EQ(parse_frames("3-1"), (std::vector{3, 2, 1}));
  EXPECT_EQ(parse_frames("-2--1"), (std::vector{-2, -1}));
  for (const char* bad : {"", "a", "1-", "1-3x0", "1-3x-1", "1,", "1 2", "1-1000000", "99999999999"})
    EXPECT_THROW(parse_frames(bad), Error) << bad;
  EXPECT_EQ(name_at_frame("shot#1/plate.####.exr", 7), "shot#1/plate.0007.exr");
  EXPECT_EQ(name_at_frame("plate.%03d.exr", 12345), "plate.12345.exr");
  EXPECT_EQ(name_at_frame("plate.%d.exr", -3), "plate.-3.exr");
  EXPECT_EQ(name_at_frame("100%.exr", 3), "100%.exr");
  EXPECT_TRUE(has_frame_pattern("a.#.exr"));
  EXPECT_FALSE(has_frame_pattern("a#/b.exr"));
  const auto files = files_at(parse_expression("a.##.exr over (b.##.exr frame [1:10 3:20])"), 2);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].file, "a.02.exr");
  EXPECT_EQ(files[1].file, "b.15.exr");
}

}  // namespace
}  // namespace lambert::composite
