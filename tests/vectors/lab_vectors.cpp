#include "vectors.h"

#include "lambert/lab/demo.h"
#include "lambert/lab/scenes.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: AA-05
const CheckOf folded_frequency("V-AA-01", [](const Vector& v) {
  for (std::size_t i = 0; i < v.input.at("f").size(); ++i)
    v.expect_near(lab::alias_frequency(v.input.at("f")[i], v.input.at("fs")), v.expected.at("apparent")[i]);
});

// rows: AA-14
const CheckOf pixel_example("V-AA-06", [](const Vector& v) {
  const lab::Shown shown = lab::show_pixel({});
  for (std::size_t i = 0; i < 2; ++i) {
    v.expect_near(shown.facts[i].second, v.expected.at("red_fraction")[i]);
    EXPECT_DOUBLE_EQ(9 * shown.facts[i].second, v.input.at("red_samples")[i].get<double>());
  }
});

// rows: AA-16
const CheckOf comb_beat("V-AA-07", [](const Vector& v) {
  const double pitch = v.input.at("pitch"), period = lab::alias_period(pitch);
  v.expect_near(period, v.expected.at("beat_period_pixels"));
  v.expect_near(1 / period, v.expected.at("alias_frequency_per_pixel"));
  EXPECT_EQ(lab::Comb{}.teeth, v.input.at("combs").get<int>());
  EXPECT_EQ(lab::Comb{}.pitch, pitch);
});

}  // namespace
}  // namespace lambert
