#include "lambert/image/hdr/response.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/colour.h"
#include "lambert/image/hdr/expose.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/hdr/range.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <limits>

namespace lambert::hdr {
namespace {

std::filesystem::path temporary(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("lambert-response-" + std::to_string(getpid()) + ".csv");
  write_atomically(path, text);
  return path;
}

TEST(Response, EncodesAndDecodes) {
  for (const std::string& name : response_names()) {
    const Response r = response_named(name, 3, 256);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_FLOAT_EQ(r.channel(c).front(), 0);
      EXPECT_FLOAT_EQ(r.channel(c).back(), 1);
      for (double code = 0; code <= 255; code += 0.25)
        ASSERT_NEAR(encode(r.channel(c), decode(r.channel(c), code)), code, 1e-3) << name;
    }
  }
  EXPECT_NEAR(static_cast<double>(response_named("srgb", 1, 256).channel(0)[100]),
              static_cast<double>(srgb_decode8(100)), 1e-6);
  EXPECT_NEAR(static_cast<double>(response_named("gamma2", 1, 256).channel(0)[51]), 0.04, 1e-6);
  EXPECT_EQ(encode(response_named("srgb", 1, 256).channel(0), std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_THROW(response_named("sgrb", 1, 256), Error);
  EXPECT_THROW(response_named("gamma x", 1, 256), Error);
  EXPECT_THROW(response_named("gamma 0", 1, 256), Error);
}

TEST(Response, IsReadBackAsWritten) {
  for (const std::string name : {"srgb", "film"})
    for (const ResponseTable table : {ResponseTable::by_code, ResponseTable::by_exposure}) {
      const Response r = response_named(name, 3, 256);
      const Response back = read_response(temporary(response_csv(r, table)), 3, 256);
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t z = 3; z < 256; ++z)
          ASSERT_NEAR(back.channel(c)[z] / r.channel(c)[z], 1, table == ResponseTable::by_code ? 1e-5 : 4e-3)
              << name << z;
    }
}

TEST(Response, RefusesTablesThatAreNone) {
  for (const char* bad : {"", "0,0\n", "0,0\n1,x\n", "0,0\n1\n", "0,0\n0,1\n", "0,1\n1,0\n", "0,1\n1,1\n",
                          "0,0,0,0\n1,1\n", "0,-1\n1,1\n", "0,0\n1,2\n", "0 0 0\n1 1 1\n", "nan,0\n1,1\n"})
    EXPECT_THROW(read_response(temporary(bad), 3, 256), Error) << bad;
}

// rows: LF-16
TEST(Expose, RoundsTheResponseOfClippedLight) {
  Image map(5, 1, {"Y"});
  const float light[] = {0.25f, 0.5f, 3, -1, std::numeric_limits<float>::quiet_NaN()};
  for (int x = 0; x < 5; ++x) map.at(x, 0, 0) = light[x];
  const Response linear = response_named("linear", 1, 65536);
  EXPECT_EQ(expose(map, linear, {}).bytes, (std::vector<std::uint8_t>{64, 128, 255, 0, 0}));
  EXPECT_EQ(expose(map, linear, {.exposure = 0.25}).bytes, (std::vector<std::uint8_t>{16, 32, 191, 0, 0}));
  EXPECT_EQ(expose(map, linear, {.bits = 16}).words, (std::vector<std::uint16_t>{16384, 32768, 65535, 0, 0}));
  map.at(0, 0, 0) = std::numeric_limits<float>::infinity();
  EXPECT_EQ(expose(map, response_named("srgb", 1, 65536), {}).bytes[0], 255);
}

// rows: LF-16
// A long exposure saturates what a short one shows, and the short one loses the dark.
TEST(Expose, LongAndShortExposuresShowDifferentEnds) {
  const Image map = test_map(64, 64);
  const auto count = [&](double exposure, int code) {
    const auto bytes = expose(map, response_named("srgb", 3, 65536), {.exposure = exposure}).bytes;
    return std::count(bytes.begin(), bytes.end(), code);
  };
  EXPECT_GT(count(16, 255), 64 * 64);
  EXPECT_EQ(count(1e-2, 255), 0);
  EXPECT_GT(count(1e-6, 0), 64 * 64);
  EXPECT_EQ(count(16, 0), 0);
}

// rows: LF-16
TEST(Expose, NoiseHasTheVarianceOfItsElectrons) {
  Image map(128, 128, {"Y"});
  for (float& v : map.pixels()) v = 0.25f;
  for (const double full_well : {60.0, 2000.0}) {
    const auto words = expose(map, response_named("linear", 1, 65536),
                              {.noise = {.full_well = full_well, .read_noise = 3}, .bits = 16})
                           .words;
    double sum = 0, squares = 0;
    for (const std::uint16_t w : words) {
      const double electrons = w / 65535.0 * full_well;
      sum += electrons, squares += electrons * electrons;
    }
    const double n = static_cast<double>(words.size()), mean = sum / n, variance = squares / n - mean * mean;
    EXPECT_NEAR(mean / (0.25 * full_well), 1, 0.01);
    EXPECT_NEAR(variance / (0.25 * full_well + 9), 1, 0.06);
  }
}

// rows: LF-15 LF-17
TEST(Range, CountsWhatIsNoLight) {
  Image map(4, 1, rgb_channels());
  map.set_rgb(0, 0, {121.741f, 1, 0});
  map.set_rgb(1, 0, {0.005f, -2, std::numeric_limits<float>::infinity()});
  const RadianceRange r = radiance_range(map);
  EXPECT_NEAR(r.ratio(), 24348.2, 0.01);
  EXPECT_NEAR(r.stops(), std::log2(24348.2), 1e-4);
  EXPECT_EQ(r.values, 12u);
  EXPECT_EQ(r.negative, 1u);
  EXPECT_EQ(r.not_finite, 1u);
  EXPECT_EQ(r.zero, 7u);
  EXPECT_EQ(radiance_range(Image(1, 1, {"Y"})).ratio(), 1);
}

}  // namespace
}  // namespace lambert::hdr
