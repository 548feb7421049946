#include "lambert/image/hdr/exposure.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/hdr/hdr_test_tools.h"
#include "lambert/image/io.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace lambert::hdr {
namespace {

class Exposure : public testing::Test {
 protected:
  Exposure() : folder_(std::filesystem::temp_directory_path() / ("lambert-hdr-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Exposure() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path file(const std::string& name, const std::string& text) {
    write_atomically(folder_ / name, text);
    return folder_ / name;
  }
  std::string refusal(const std::string& name, const std::string& text) {
    try {
      read_exposure_list(file(name, text));
    } catch (const Error& e) {
      return std::string(e.what()).substr(folder_.string().size() + 1);
    }
    return "none";
  }
  std::filesystem::path folder_;
};

// rows: LF-11
TEST_F(Exposure, FollowsTimeApertureAndSpeed) {
  EXPECT_DOUBLE_EQ(relative_exposure({.time = 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(relative_exposure({.time = 0.5, .f_number = 2, .iso = 400}), 0.5);
  EXPECT_DOUBLE_EQ(relative_exposure({.time = 1, .density = 1}), 0.1);
  EXPECT_DOUBLE_EQ(parse_exposure_time("1/60", "--times"), 1.0 / 60);
  EXPECT_DOUBLE_EQ(parse_exposure_time("2.5s", "--times"), 2.5);
  for (const char* bad : {"", "0", "-1", "1/0", "x", "1/60x", "nan", "1/"})
    EXPECT_THROW(parse_exposure_time(bad, "--times"), Error);
}

TEST_F(Exposure, ReadsLists) {
  const auto list =
      read_exposure_list(file("list.txt", "# photographs\na.png 1/8\n\n/b/c.png 0.5, 4 200 # widest\r\n"));
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].file, folder_ / "a.png");
  EXPECT_EQ(list[0].setting.time, 0.125);
  EXPECT_EQ(list[1].file, "/b/c.png");
  EXPECT_EQ(relative_exposure(list[1].setting), 0.5 * 2 / 16);
  const auto hdrgen = read_exposure_list(file("a.hdrgen", "/photos/img08.jpg 4 2.8 100 0\n"));
  EXPECT_EQ(hdrgen[0].setting.time, 0.25);
  EXPECT_EQ(hdrgen[0].setting.f_number, 2.8);
}

TEST_F(Exposure, NamesTheLineAtFault) {
  EXPECT_EQ(refusal("l.txt", "a.png 1\nb.png\n"), "l.txt:2: expected a file and its exposure time, got only 'b.png'");
  EXPECT_EQ(refusal("l.txt", "a.png no\n"),
            "l.txt:1: expected an exposure time in seconds above 0, such as 1/60 or 0.5, got 'no'");
  EXPECT_EQ(refusal("l.txt", "# nothing\n"), "l.txt: lists no photographs");
  EXPECT_NE(refusal("l.txt", "a.png 1 0\n").find("f-number"), std::string::npos);
}

TEST_F(Exposure, RefusesWhatIsUnknownOrOfTwoKinds) {
  EXPECT_THROW(relative_exposures({"a", "b"}, {{.time = 1}, {}}), Error);
  EXPECT_THROW(relative_exposures({"a", "b"}, {{.time = 1, .f_number = 4}, {.time = 2}}), Error);
  EXPECT_THROW(relative_exposures({"a", "b"}, {{.time = 1}, {.time = 2, .iso = 100}}), Error);
  EXPECT_EQ(relative_exposures({"a", "b"}, {{.time = 1}, {.time = 2}}), (std::vector<double>{1, 2}));
}

// rows: LF-11
TEST_F(Exposure, StacksAreCheckedAgainstTheirImages) {
  const Image map = test_map(64, 48);
  ExposureStack stack = photographs(map, "srgb", {1, 0.25, 0.5});
  check_exposures(stack);
  EXPECT_EQ(stack.frames[0].exposure, 0.25);
  EXPECT_EQ(stack.frames[2].exposure, 1);
  ExposureStack equal = photographs(map, "srgb", {1, 1});
  EXPECT_THROW(check_exposures(equal), Error);
  ExposureStack swapped = photographs(map, "srgb", {0.02, 0.08});
  std::swap(swapped.frames[0].exposure, swapped.frames[1].exposure);
  EXPECT_THROW(check_exposures(swapped), Error);
  ExposureStack same = photographs(map, "srgb", {0.02, 0.08});
  same.frames[1].codes = same.frames[0].codes;
  EXPECT_THROW(check_exposures(same), Error);
}

TEST_F(Exposure, ReadsCodesAsTheyAre) {
  Image grey(3, 2, {"Y"});
  grey.at(1, 0, 0) = 1, grey.at(2, 1, 0) = 0.2158605f;  // code 128
  write_image(folder_ / "a.png", grey);
  write_image(folder_ / "b.tif", grey);
  write_image(folder_ / "c.png", test_map(3, 2));
  write_image(folder_ / "d.png", Image(4, 2, {"Y"}));
  write_image(folder_ / "e.exr", grey);
  const auto name = [&](const char* n) { return (folder_ / n).string(); };
  const ExposureStack eight = read_stack({name("a.png")}, {1});
  EXPECT_EQ(eight.levels, 256);
  EXPECT_EQ(eight.channels, 1u);
  EXPECT_EQ(std::get<0>(eight.frames[0].codes), (std::vector<std::uint8_t>{0, 255, 0, 0, 0, 128}));
  const ExposureStack mixed = read_stack({name("a.png"), name("b.tif")}, {1, 2});
  EXPECT_EQ(mixed.levels, 65536);
  EXPECT_EQ(mixed.codes<std::uint16_t>(0)[5], 128 * 257);
  EXPECT_NEAR(mixed.codes<std::uint16_t>(1)[5], 128 * 257, 2);
  EXPECT_THROW(read_stack({name("a.png"), name("c.png")}, {1, 2}), Error);
  EXPECT_THROW(read_stack({name("a.png"), name("d.png")}, {1, 2}), Error);
  EXPECT_THROW(read_stack({name("e.exr")}, {1}), Error);
}

}  // namespace
}  // namespace lambert::hdr
