#include "lambert/material/spectrum.h"

#include <algorithm>
#include <array>

namespace lambert {
namespace {

struct NamedMetal {
  std::string_view name;
  MetalData data;
};

// Measured n and k, taken to RGB by spectrum_to_reflectance_rgb. Sources: Palik, "Handbook of Optical Constants of
// Solids", as tabulated in the spectra that accompany pbrt-v2 (Ag, Al, Au, Be, Cu, Hg, Ir, Mo, Nb, Rh, Ta, W, TiN, MgO
// and TiO2); Johnson and Christy, Phys. Rev. B 9, 5056 (1974) (Cr, Fe, Ni, Ti); Rakić et al., Appl. Opt. 37, 5271
// (1998) (Pt); Querry, report CRDC-CR-85034 (1985) (CuZn: brass, 70 % Cu). MgO and TiO2 are no metals, but pbrt names
// them with these.
constexpr std::array metals = {
    NamedMetal{"Ag", {{0.1288f, 0.1231f, 0.1522f}, {3.9987f, 3.2990f, 2.3606f}}},
    NamedMetal{"Al", {{1.3692f, 0.9326f, 0.5728f}, {7.6438f, 6.6205f, 5.3188f}}},
    NamedMetal{"Au", {{0.1213f, 0.3926f, 1.5868f}, {3.2964f, 2.5224f, 1.7622f}}},
    NamedMetal{"Be", {{3.4727f, 3.3597f, 3.0619f}, {3.1826f, 3.1748f, 3.1553f}}},
    NamedMetal{"Cr", {{3.2242f, 3.1170f, 2.2557f}, {3.2913f, 3.3388f, 3.1131f}}},
    NamedMetal{"Cu", {{0.1697f, 0.9709f, 1.2128f}, {3.2363f, 2.5937f, 2.3554f}}},
    NamedMetal{"CuZn", {{0.4325f, 0.5140f, 1.1460f}, {3.5845f, 2.6946f, 1.7498f}}},
    NamedMetal{"Fe", {{2.9168f, 2.9213f, 2.5316f}, {3.0650f, 2.9394f, 2.7417f}}},
    NamedMetal{"Hg", {{1.9853f, 1.5228f, 0.9999f}, {5.2446f, 4.6159f, 3.7627f}}},
    NamedMetal{"Ir", {{2.5588f, 2.1983f, 1.7790f}, {4.6372f, 4.2924f, 3.5930f}}},
    NamedMetal{"MgO", {{1.7344f, 1.7408f, 1.7540f}, {0, 0, 0}}},
    NamedMetal{"Mo", {{3.7194f, 3.7194f, 3.0529f}, {3.4111f, 3.6079f, 3.4653f}}},
    NamedMetal{"Nb", {{2.8410f, 2.9414f, 2.6348f}, {2.8554f, 2.8873f, 2.8375f}}},
    NamedMetal{"Ni", {{2.0101f, 1.9038f, 1.7193f}, {4.1211f, 3.5740f, 2.8626f}}},
    NamedMetal{"Pt", {{2.3221f, 2.0698f, 1.8138f}, {4.1861f, 3.6838f, 3.0639f}}},
    NamedMetal{"Rh", {{2.1436f, 1.9634f, 1.7095f}, {5.6214f, 4.9652f, 4.3722f}}},
    NamedMetal{"Ta", {{1.7194f, 2.5180f, 2.8911f}, {1.9920f, 1.8397f, 2.1410f}}},
    NamedMetal{"Ti", {{2.7161f, 2.5114f, 2.2266f}, {3.7915f, 3.4034f, 2.9996f}}},
    NamedMetal{"TiN", {{1.3665f, 1.2142f, 1.5172f}, {2.7885f, 2.0552f, 1.2113f}}},
    NamedMetal{"TiO2", {{2.8696f, 2.9540f, 3.1951f}, {0, 0, 0}}},
    NamedMetal{"W", {{3.6246f, 3.4824f, 3.2972f}, {2.9043f, 2.7482f, 2.4999f}}},
};

}  // namespace

std::optional<MetalData> named_metal(std::string_view name) {
  const auto found = std::find_if(metals.begin(), metals.end(), [&](const auto& m) { return m.name == name; });
  return found == metals.end() ? std::nullopt : std::optional(found->data);
}

std::vector<std::string> metal_names() {
  std::vector<std::string> names;
  for (const NamedMetal& m : metals) names.emplace_back(m.name);
  return names;
}

}  // namespace lambert
