#include "lambert/material/spectrum.h"

#include <algorithm>
#include <array>

namespace lambert {
namespace {

struct NamedGlass {
  std::string_view name;
  GlassData data;
};

// n_d and V_d. Schott's optical glass data sheets (the lead-free N- types carry the plain name, too, where the old type
// is discontinued). pbrt calls SF5, SF10 and SF11 "F5", "F10" and "F11". Water at 20 °C: Daimon and Masumura 2007.
// Ice: Warren and Brandt 2008. Fused silica: Malitson 1965. Sapphire, ordinary ray: Malitson and Dodge 1972. Diamond:
// Peter 1923. Acrylic, polycarbonate and polystyrene: Sultanova et al. 2009.
constexpr std::array glasses = {
    NamedGlass{"BK7", {1.51680f, 64.17f}},         NamedGlass{"N-BK7", {1.51680f, 64.17f}},
    NamedGlass{"K5", {1.52249f, 59.48f}},          NamedGlass{"BAF10", {1.67003f, 47.11f}},
    NamedGlass{"N-BAF10", {1.67003f, 47.11f}},     NamedGlass{"FK51A", {1.48656f, 84.47f}},
    NamedGlass{"N-FK51A", {1.48656f, 84.47f}},     NamedGlass{"LASF9", {1.85025f, 32.17f}},
    NamedGlass{"N-LASF9", {1.85025f, 32.17f}},     NamedGlass{"SK16", {1.62041f, 60.32f}},
    NamedGlass{"LAK9", {1.69100f, 54.71f}},        NamedGlass{"F2", {1.62004f, 36.37f}},
    NamedGlass{"F5", {1.67270f, 32.21f}},          NamedGlass{"SF5", {1.67270f, 32.21f}},
    NamedGlass{"F10", {1.72825f, 28.41f}},         NamedGlass{"SF10", {1.72825f, 28.41f}},
    NamedGlass{"F11", {1.78472f, 25.76f}},         NamedGlass{"SF11", {1.78472f, 25.76f}},
    NamedGlass{"SF6", {1.80518f, 25.43f}},         NamedGlass{"SF66", {1.92286f, 20.88f}},
    NamedGlass{"fused-silica", {1.45846f, 67.8f}}, NamedGlass{"acrylic", {1.4918f, 57.4f}},
    NamedGlass{"polycarbonate", {1.5848f, 27.9f}}, NamedGlass{"polystyrene", {1.5916f, 30.9f}},
    NamedGlass{"sapphire", {1.76823f, 72.3f}},     NamedGlass{"diamond", {2.4175f, 55.3f}},
    NamedGlass{"water", {1.33336f, 55.8f}},        NamedGlass{"ice", {1.3098f, 54.4f}},
};

}  // namespace

std::optional<GlassData> named_glass(std::string_view name) {
  const auto found = std::find_if(glasses.begin(), glasses.end(), [&](const auto& g) { return g.name == name; });
  return found == glasses.end() ? std::nullopt : std::optional(found->data);
}

std::vector<std::string> glass_names() {
  std::vector<std::string> names;
  for (const NamedGlass& g : glasses) names.emplace_back(g.name);
  return names;
}

}  // namespace lambert
