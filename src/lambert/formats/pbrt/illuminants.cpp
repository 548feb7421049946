#include "lambert/formats/pbrt/illuminants.h"

#include "lambert/material/spectrum.h"

#include <algorithm>
#include <array>

namespace lambert::pbrt {
namespace {

struct Illuminant {
  const char* name;
  float x, y;  // chromaticity, CIE 1931 2°
};

// CIE 15:2004, tables T.3 and T.8; ACES white from SMPTE ST 2065-1.
constexpr std::array<Illuminant, 19> illuminants{{
    {"stdillum-A", 0.44758f, 0.40745f},    {"stdillum-D50", 0.34567f, 0.35851f}, {"stdillum-D55", 0.33243f, 0.34744f},
    {"stdillum-D65", 0.31272f, 0.32903f},  {"stdillum-D75", 0.29903f, 0.31488f}, {"stdillum-E", 1.0f / 3, 1.0f / 3},
    {"stdillum-F1", 0.3131f, 0.3371f},     {"stdillum-F2", 0.3721f, 0.3751f},    {"stdillum-F3", 0.4091f, 0.3941f},
    {"stdillum-F4", 0.4402f, 0.4031f},     {"stdillum-F5", 0.3138f, 0.3452f},    {"stdillum-F6", 0.3779f, 0.3882f},
    {"stdillum-F7", 0.3129f, 0.3292f},     {"stdillum-F8", 0.3458f, 0.3586f},    {"stdillum-F9", 0.3741f, 0.3727f},
    {"stdillum-F10", 0.3458f, 0.3588f},    {"stdillum-F11", 0.3805f, 0.3769f},   {"stdillum-F12", 0.4370f, 0.4042f},
    {"illum-acesD60", 0.32168f, 0.33767f},
}};

}  // namespace

std::optional<Rgb> named_illuminant(std::string_view name) {
  const auto i = std::find_if(illuminants.begin(), illuminants.end(), [&](const auto& e) { return name == e.name; });
  if (i == illuminants.end()) return std::nullopt;
  return xyz_to_rgb({i->x / i->y, 1, (1 - i->x - i->y) / i->y});
}

std::vector<std::string> illuminant_names() {
  std::vector<std::string> names;
  for (const Illuminant& i : illuminants) names.emplace_back(i.name);
  return names;
}

}  // namespace lambert::pbrt
