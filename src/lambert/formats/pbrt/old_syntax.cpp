#include "lambert/formats/pbrt/old_syntax.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::pbrt {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

template <std::size_t N>
std::string_view look_up(const std::array<Entry, N>& table, std::string_view word) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.first == word; });
  return found == table.end() ? std::string_view() : found->second;
}

constexpr std::string_view advice = "pbrt-v4's own `pbrt --upgrade` converts pbrt-v3 files";

constexpr std::array<Entry, 6> directives{{
    {"SurfaceIntegrator", "pbrt-v4 writes Integrator \"path\""},
    {"VolumeIntegrator", "pbrt-v4 writes Integrator \"volpath\""},
    {"Renderer", "pbrt-v4 writes Integrator \"path\""},
    {"Volume", "pbrt-v4 writes MakeNamedMedium"},
    {"WorldEnd", "pbrt-v4 files just end"},
    {"TransformBegin", "pbrt-v4 writes AttributeBegin and AttributeEnd"},
}};

constexpr std::array<Entry, 11> materials{{
    {"matte", "diffuse"},
    {"plastic", "coateddiffuse"},
    {"substrate", "coateddiffuse"},
    {"uber", "coateddiffuse"},
    {"metal", "conductor"},
    {"mirror", "conductor"},
    {"shinymetal", "conductor"},
    {"glass", "dielectric"},
    {"translucent", "diffusetransmission"},
    {"none", "interface"},
    {"disney", "coateddiffuse"},
}};

constexpr std::array<Entry, 8> others{{
    {"image", "rgb"},
    {"lowdiscrepancy", "zsobol"},
    {"random", "independent"},
    {"02sequence", "zsobol"},
    {"maxmindist", "zsobol"},
    {"environment", "spherical"},
    {"area", "diffuse"},
    {"directlighting", "path"},
}};

std::string renamed(std::string_view now) {
  if (now.empty()) return "";
  return "; this is the syntax of pbrt-v2 or v3: pbrt-v4 calls it '" + std::string(now) + "' (" + std::string(advice) +
         ")";
}

}  // namespace

std::string old_directive_hint(std::string_view directive) {
  const std::string_view known = look_up(directives, directive == "TransformEnd" ? "TransformBegin" : directive);
  if (known.empty()) return "";
  return "'" + std::string(directive) +
         "' is the syntax of pbrt-v2 or v3, and this reader takes pbrt-v4: " + std::string(known) + " (" +
         std::string(advice) + ")";
}

std::string old_parameter_type_hint(std::string_view type) { return renamed(type == "color" ? "rgb" : ""); }
std::string old_material_hint(std::string_view type) { return renamed(look_up(materials, type)); }
std::string old_type_hint(std::string_view type) { return renamed(look_up(others, type)); }

}  // namespace lambert::pbrt
