#include "lambert/image/channels.h"

#include "damage.h"
#include "lambert/image/formats/exr_names.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

using Names = std::vector<std::string>;

Names chosen(const Names& names, const std::string& layer, const Names& wanted) {
  Names result;
  for (const ChannelChoice& c : chosen_channels(names, layer, wanted, "a.exr"))
    result.push_back(c.name + "<" + names[c.stored]);
  return result;
}

TEST(Channels, AreChosenByLayerAndName) {
  const Names names = {"R", "G", "B", "Z", "light.sun.R", "light.sun.G", "albedo.R"};
  EXPECT_EQ(chosen(names, "light.sun", {}), (Names{"R<light.sun.R", "G<light.sun.G"}));
  EXPECT_EQ(chosen(names, "", {"B", "A=Z", "albedo.R"}), (Names{"B<B", "A<Z", "albedo.R<albedo.R"}));
  EXPECT_EQ(chosen(names, "albedo", {"G=R", "R"}), (Names{"G<albedo.R", "R<albedo.R"}));
  for (const auto& [layer, wanted, part] : {std::tuple{"albdo", Names{}, "albedo"},
                                            {"", Names{"Q"}, "no channel 'Q'"},
                                            {"", Names{"R", "R"}, "twice"},
                                            {"", Names{"=R"}, "a name"}})
    EXPECT_NE(error_of([&, &l = layer, &w = wanted] { chosen(names, l, w); }).find(part), std::string::npos) << part;
}

TEST(Channels, LightIsColourAndLuminance) {
  EXPECT_EQ(light_channels(
                {"R", "G", "B", "A", "Z", "sky.Y", "normal.R", "normal.G", "normal.B", "N.X", "N.Y", "variance.Y"}),
            (std::vector<bool>{true, true, true, false, false, true, false, false, false, false, false, false}));
}

TEST(Channels, NamesOfPartsDoNotCollide) {
  const auto named = [](const Names& parts, const std::vector<Names>& channels) {
    Names result;
    for (const ExrChannel& c : named_channels(parts, channels)) result.push_back(c.name);
    return result;
  };
  EXPECT_EQ(named({"left", "right"}, {{"R"}, {"R"}}), (Names{"R", "right.R"}));
  EXPECT_EQ(named({"x", "Beauty"}, {{"R"}, {"R"}}), (Names{"x.R", "R"}));
  EXPECT_EQ(named({"a", "b", "b"}, {{"b.R"}, {"R"}, {"R"}}), (Names{"b.R", "1.b.R", "2.b.R"}));
  EXPECT_EQ(named({"", "", ""}, {{"R"}, {"R"}, {"R"}}), (Names{"R", "part1.R", "part2.R"}));
}

}  // namespace
}  // namespace lambert
