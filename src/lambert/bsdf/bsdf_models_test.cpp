#include "lambert/base/hash.h"
#include "lambert/base/transform.h"
#include "lambert/bsdf/any_bsdf.h"
#include "lambert/bsdf/fresnel.h"
#include "lambert/sampling/warp.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <string>

namespace lambert {
namespace {

/// `least` bounds the share of the energy that comes back from below at cos θo >= 0.5 (0: absorbs), `albedo_error` the
/// error of albedo() there and at grazing directions.
struct NamedBsdf {
  const char* name;
  Bsdf bsdf;
  double least = 0, albedo_error = 0.03;
  int subdivisions = 12;  ///< of the bins: narrow lobes need more
};
void PrintTo(const NamedBsdf& b, std::ostream* out) { *out << b.name; }

const Rgb gold_eta(0.143f, 0.375f, 1.442f), gold_k(3.983f, 2.386f, 1.603f), gray(0.5f), rust(0.8f, 0.3f, 0.1f);
const Rgb white_k = conductor_k_of_reflectance(Rgb(0.9999f));

Conductor white_metal(float x, float y) { return {.eta = Rgb(1), .k = white_k, .alpha_x = x, .alpha_y = y}; }
Conductor gold(float x, float y) { return {.eta = gold_eta, .k = gold_k, .alpha_x = x, .alpha_y = y}; }
CoatedConductor lacquered(float coat, float metal) {
  return {.coat = {1.5f, coat, coat}, .metal = {gold_eta / 1.5f, gold_k / 1.5f, metal, metal}};
}

const std::array models = {
    NamedBsdf{"diffuse", Diffuse{rust}},
    NamedBsdf{"diffuse_white", Diffuse{Rgb(1)}, 0.999},
    NamedBsdf{"sheet", DiffuseTransmission{rust, gray * 0.2f}},
    NamedBsdf{"sheet_white", DiffuseTransmission{Rgb(0.3f), Rgb(0.7f)}, 0.999},
    NamedBsdf{"mirror", gold(0, 0)},
    NamedBsdf{"metal_05", white_metal(0.05f, 0.05f), 0.98, 0.03, 28},
    NamedBsdf{"metal_20", white_metal(0.2f, 0.2f), 0.88, 0.03},
    NamedBsdf{"metal_50", gold(0.5f, 0.5f), 0, 0.06},
    NamedBsdf{"metal_100", white_metal(1, 1), 0.27, 0.03},
    NamedBsdf{"metal_brushed", gold(0.05f, 0.4f), 0, 0.09},
    NamedBsdf{"glass_smooth", Dielectric{1.5f, 0, 0}, 0.9999},
    NamedBsdf{"glass_05", Dielectric{1.5f, 0.05f, 0.05f}, 0.98, 0.06, 40},
    NamedBsdf{"glass_20", Dielectric{1.5f, 0.2f, 0.2f}, 0.86, 0.15},
    NamedBsdf{"glass_50", Dielectric{1.5f, 0.5f, 0.5f}, 0.62, 0.4},
    NamedBsdf{"glass_100", Dielectric{1.5f, 1, 1}, 0.42, 0.6},
    NamedBsdf{"glass_brushed", Dielectric{1.33f, 0.1f, 0.5f}, 0.74, 0.3},
    NamedBsdf{"bubble", Dielectric{1 / 1.5f, 0.2f, 0.2f}, 0.84, 0.2},
    NamedBsdf{"no_border", Dielectric{1, 0.2f, 0.2f}, 0.9999},
    NamedBsdf{"pane", ThinDielectric{1.5f}, 0.9999},
    NamedBsdf{"plastic_smooth", CoatedDiffuse(rust, 1.5f, 0, 0)},
    NamedBsdf{"plastic_white", CoatedDiffuse(Rgb(1), 1.5f, 0, 0), 0.99},
    NamedBsdf{"plastic_05", CoatedDiffuse(rust, 1.5f, 0.05f, 0.05f), 0, 0.06, 28},
    NamedBsdf{"plastic_20", CoatedDiffuse(Rgb(1), 1.5f, 0.2f, 0.2f), 0.97, 0.22},
    NamedBsdf{"plastic_50", CoatedDiffuse(Rgb(1), 1.5f, 0.5f, 0.5f), 0.9, 0.3},
    NamedBsdf{"plastic_100", CoatedDiffuse(Rgb(1), 1.5f, 1, 1), 0.8, 0.34},
    NamedBsdf{"plastic_brushed", CoatedDiffuse(rust, 1.5f, 0.05f, 0.4f), 0, 0.25},
    NamedBsdf{"lacquered_smooth", lacquered(0, 0)},
    NamedBsdf{"lacquered_05_20", lacquered(0.05f, 0.2f), 0, 0.35, 28},
    NamedBsdf{"lacquered_0_50", lacquered(0, 0.5f), 0, 0.5},
    NamedBsdf{"lacquered_50_0", lacquered(0.5f, 0), 0, 0.3},
    NamedBsdf{"lacquered_100_50", lacquered(1, 0.5f), 0, 0.6},
    NamedBsdf{"gltf_default", GltfPbr{}, 0.9},
    NamedBsdf{"gltf_smooth", GltfPbr{.alpha_x = 0, .alpha_y = 0}, 0.97},
    NamedBsdf{"gltf_20", GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.2f}, 0.97},
    NamedBsdf{"gltf_metal", GltfPbr{.base_colour = rust, .metallic = 1, .alpha_x = 0.2f, .alpha_y = 0.2f}},
    NamedBsdf{"gltf_half_metal", GltfPbr{.base_colour = rust, .metallic = 0.5f, .alpha_x = 0.05f, .alpha_y = 0.5f}, 0,
              0.08},
    NamedBsdf{"gltf_specular", GltfPbr{.alpha_x = 0.5f, .alpha_y = 0.5f, .specular_colour = Rgb(1, 0.5f, 0.2f)}},
    NamedBsdf{"gltf_coat", GltfPbr{.alpha_x = 0.5f, .alpha_y = 0.5f, .clearcoat = 1}, 0, 0.2},
    NamedBsdf{
        "gltf_rough_coat",
        GltfPbr{.base_colour = rust, .alpha_x = 0.5f, .alpha_y = 0.2f, .clearcoat = 0.7f, .clearcoat_alpha = 0.2f}, 0,
        0.12},
    NamedBsdf{"gltf_sheen", GltfPbr{.alpha_x = 0.5f, .alpha_y = 0.5f, .sheen_colour = Rgb(1), .sheen_roughness = 0.5f},
              0.8, 0.15},
    NamedBsdf{"gltf_film", GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.2f, .iridescence = 1, .iridescence_ior = 1.8f}, 0.83,
              0.06},
    NamedBsdf{"gltf_film_metal",
              GltfPbr{.base_colour = rust, .metallic = 1, .alpha_x = 0.2f, .alpha_y = 0.2f, .iridescence = 1}, 0, 0.2},
    NamedBsdf{"gltf_pane", GltfPbr{.alpha_x = 0, .alpha_y = 0, .transmission = 1}, 0.97},
    NamedBsdf{"gltf_frosted_pane", GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.2f, .transmission = 0.6f}, 0.9, 0.1},
    NamedBsdf{"gltf_glass", GltfPbr{.alpha_x = 0, .alpha_y = 0, .transmission = 1, .thin_walled = false}, 0.97},
    NamedBsdf{"gltf_rough_glass", GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.1f, .transmission = 1, .thin_walled = false},
              0.8, 0.22},
    NamedBsdf{"gltf_milky_glass", GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.2f, .transmission = 0.5f, .thin_walled = false},
              0.5, 0.5},
    NamedBsdf{"gltf_no_border",
              GltfPbr{.alpha_x = 0.2f, .alpha_y = 0.2f, .ior = 1, .transmission = 1, .thin_walled = false}, 0.99},
    NamedBsdf{"gltf_all",
              GltfPbr{.base_colour = rust,
                      .metallic = 0.3f,
                      .alpha_x = 0.3f,
                      .alpha_y = 0.1f,
                      .specular = 0.8f,
                      .clearcoat = 0.5f,
                      .clearcoat_alpha = 0.1f,
                      .sheen_colour = Rgb(0.3f),
                      .sheen_roughness = 0.4f,
                      .iridescence = 0.5f,
                      .transmission = 0.4f},
              0, 0.09, 32},
};

Vec3 direction(float cos_theta, float phi = 0.7f) {
  const float ring = std::sqrt(1 - cos_theta * cos_theta);
  return {ring * std::cos(phi), ring * std::sin(phi), cos_theta};
}
constexpr std::array cosines = {0.95f, 0.5f, 0.1f, 0.02f, -0.6f, -0.9f};
int total_tests() { return static_cast<int>(models.size() * cosines.size()); }

float number(int i, int dimension) { return hash_to_float(hash_values(i, dimension, 77)); }
std::optional<BsdfSample> draw(const Bsdf& bsdf, Vec3 wo, int i, Transport mode = Transport::radiance) {
  return bsdf.sample(wo, number(i, 0), {number(i, 1), number(i, 2)}, mode);
}

/// Mean and error of the samples' weights: the share of energy that leaves (importance: unscaled by η²).
struct Furnace {
  Rgb mean{0.0f}, smooth{0.0f};  ///< of all lobes, and of all but Dirac ones
  double error = 0;              ///< standard error of the mean's green
};
Furnace furnace(const Bsdf& bsdf, Vec3 wo, int n = 8000) {
  Furnace f;
  double squares = 0;
  for (int i = 0; i < n; ++i) {
    const auto s = draw(bsdf, wo, i, Transport::importance);
    if (!s) continue;
    f.mean += s->weight / static_cast<float>(n), squares += static_cast<double>(s->weight.g * s->weight.g) / n;
    if (!s->specular) f.smooth += s->weight / static_cast<float>(n);
  }
  const auto g = static_cast<double>(f.mean.g);
  f.error = std::sqrt(std::max(0.0, squares - g * g) / n);
  return f;
}

class BsdfModels : public testing::TestWithParam<NamedBsdf> {
 protected:
  const Bsdf& bsdf() const { return GetParam().bsdf; }
};
INSTANTIATE_TEST_SUITE_P(All, BsdfModels, testing::ValuesIn(models),
                         [](const auto& test) { return std::string(test.param.name); });

// rows: PT-29
TEST_P(BsdfModels, SamplesFollowTheDensity) {
  if (bsdf().is_specular()) return;
  // Lobes at the pole would meet all bins of azimuth at once.
  const Transform turn = Transform::rotate(degrees(35), {1, 2, 3}), back = turn.inverse();
  for (const float cos : cosines) {
    const Vec3 wo = direction(cos);
    const auto sample = [&](Vec2 u, float u_lobe) -> std::optional<Vec3> {
      const auto s = bsdf().sample(wo, u_lobe, u);
      return s && !s->specular ? std::optional(turn.vector(s->wi)) : std::nullopt;
    };
    const auto pdf = [&](Vec3 w) { return static_cast<double>(bsdf().pdf(wo, back.vector(w))); };
    const auto result = statistics::chi_square_sphere(
        sample, pdf, {.samples = 20000, .subdivisions = GetParam().subdivisions, .tests = total_tests()});
    EXPECT_TRUE(result) << "cos " << cos << ": " << result.message;
  }
}

// rows: PT-29 IS-79
// What sampling finds is all there is: its mean is the integral of eval, by midpoints.
TEST_P(BsdfModels, SamplesMissNoPartOfTheValue) {
  for (const float cos : {0.9f, 0.3f, -0.6f}) {
    const Vec3 wo = direction(cos);
    const int rings = 400, sectors = 25 * GetParam().subdivisions;
    double value = 0, density = 0;
    for (int i = 0; i < rings * sectors; ++i) {
      const Vec3 axis_y =
          square_to_uniform_sphere({(static_cast<float>(i / sectors) + 0.5f) / static_cast<float>(rings),
                                    (static_cast<float>(i % sectors) + 0.5f) / static_cast<float>(sectors)});
      const Vec3 wi(axis_y.y, axis_y.z, axis_y.x);
      value += static_cast<double>(bsdf().eval(wo, wi, Transport::importance).g);
      density += static_cast<double>(bsdf().pdf(wo, wi));
    }
    const double area = 4 * std::numbers::pi / (rings * sectors);
    EXPECT_LE(density * area, 1.005) << cos;
    const Furnace f = furnace(bsdf(), wo);
    EXPECT_NEAR(value * area, static_cast<double>(f.smooth.g), 4 * f.error + 0.005) << cos;
    EXPECT_TRUE(!bsdf().is_specular() || value == 0) << cos;
  }
}

// rows: PT-29
TEST_P(BsdfModels, WeightsAreValueOverDensity) {
  for (const Transport mode : {Transport::radiance, Transport::importance})
    for (const float cos : cosines)
      for (int i = 0; i < 200; ++i) {
        const Vec3 wo = direction(cos);
        const auto s = draw(bsdf(), wo, i, mode);
        if (!s) continue;
        ASSERT_TRUE(is_finite(s->weight)) << cos;
        EXPECT_NEAR(length(s->wi), 1, 1e-4f);
        EXPECT_EQ(s->transmitted, !same_hemisphere(wo, s->wi));
        if (s->specular) continue;
        ASSERT_GT(s->pdf, 0);
        EXPECT_NEAR(bsdf().pdf(wo, s->wi) / s->pdf, 1, 1e-3f);
        const Rgb expected = bsdf().eval(wo, s->wi, mode) / s->pdf;
        EXPECT_NEAR(s->weight.r, expected.r, 1e-3f * expected.r);
        EXPECT_NEAR(s->weight.b, expected.b, 1e-3f * expected.b);
      }
}

// rows: IS-80
// f(wo, wi) = f*(wi, wo) (Veach 1997, sec. 5.2): radiance one way scatters like importance the other way.
TEST_P(BsdfModels, AreReciprocal) {
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = square_to_uniform_sphere({number(i, 3), number(i, 4)});
    const auto s = draw(bsdf(), a, i);
    const Vec3 b = s && i % 2 == 0 ? s->wi : square_to_uniform_sphere({number(i, 5), number(i, 6)});
    if (std::abs(a.z) < 1e-2f || std::abs(b.z) < 1e-2f) continue;
    const Rgb there = bsdf().eval(a, b, Transport::radiance) / std::abs(b.z),
              back = bsdf().eval(b, a, Transport::importance) / std::abs(a.z);
    ASSERT_NEAR(there.r, back.r, 5e-3f * there.r + 1e-5f) << a.z << " " << b.z;
    ASSERT_NEAR(there.b, back.b, 5e-3f * there.b + 1e-5f) << a.z << " " << b.z;
  }
}

// rows: IS-79
TEST_P(BsdfModels, GiveBackNoMoreThanTheyGet) {
  for (const float cos : {1.0f, 0.95f, 0.7f, 0.5f, 0.2f, 0.1f, 0.02f, -0.02f, -0.3f, -0.6f, -0.9f}) {
    const Furnace f = furnace(bsdf(), direction(cos));
    EXPECT_LE(static_cast<double>(max_component(f.mean)), 1.005 + 4 * f.error) << cos;
    const double least = std::abs(cos) >= 0.5f ? GetParam().least : 0;
    EXPECT_GE(static_cast<double>(f.mean.g), least - 4 * f.error - 1e-6) << cos;
  }
}

TEST_P(BsdfModels, AlbedoIsNearTheSamplesMean) {
  for (const float cos : {1.0f, 0.95f, 0.7f, 0.5f, 0.2f, -0.6f}) {
    const Furnace f = furnace(bsdf(), direction(cos));
    const Rgb albedo = bsdf().albedo(direction(cos));
    EXPECT_NEAR(static_cast<double>(albedo.g), static_cast<double>(f.mean.g), GetParam().albedo_error + 4 * f.error)
        << cos;
  }
}

TEST_P(BsdfModels, TheHorizonGivesNumbers) {
  const std::array edges = {Vec3(1, 0, 0),  Vec3(0, -1, 0),   Vec3(0, 0, 1),
                            Vec3(0, 0, -1), direction(1e-6f), direction(-1e-6f)};
  for (const Vec3 wo : edges) {
    EXPECT_TRUE(is_finite(bsdf().albedo(wo))) << wo.z;
    for (const Vec3 wi : {edges[0], edges[1], edges[2], edges[3], edges[4], edges[5], -wo, Vec3(-wo.x, -wo.y, wo.z)}) {
      const float pdf = bsdf().pdf(wo, wi);
      EXPECT_TRUE(is_finite(bsdf().eval(wo, wi))) << wo.z << " " << wi.z;
      EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << wo.z << " " << wi.z << " " << pdf;
    }
    for (const float u : {0.0f, 0.5f, one_minus_epsilon})
      for (const float v : {0.0f, 0.5f, one_minus_epsilon}) {
        const auto s = bsdf().sample(wo, u, {v, u});
        if (!s) continue;
        EXPECT_TRUE(is_finite(s->weight) && min_component(s->weight) >= 0) << wo.z;
        EXPECT_NEAR(length(s->wi), 1, 1e-3f);
      }
  }
}

}  // namespace
}  // namespace lambert
