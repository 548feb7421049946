#include "lambert/formats/ply/vertices.h"

#include "lambert/base/error.h"
#include "lambert/image/colour.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace lambert::ply {
namespace {

constexpr std::size_t normal_slot = 3, uv_slot = 6, colour_slot = 8;

std::optional<std::size_t> slot_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 20> names{
      {{"x", 0}, {"y", 1}, {"z", 2},  {"nx", 3},        {"ny", 4},        {"nz", 5},    {"u", 6},
       {"v", 7}, {"s", 6}, {"t", 7},  {"red", 8},       {"green", 9},     {"blue", 10}, {"alpha", 11},
       {"r", 8}, {"g", 9}, {"b", 10}, {"texture_u", 6}, {"texture_v", 7}, {"a", 11}}};
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

float colour_scale(Type t) { return t == Type::uint8 ? 1.0f / 255 : t == Type::uint16 ? 1.0f / 65535 : 1.0f; }

}  // namespace

VertexLayout::VertexLayout(const Element& vertex, const std::string& name)
    : element_(vertex), slots_(vertex.properties.size()) {
  std::array<bool, slot_count> present{};
  for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
    const Property& p = vertex.properties[i];
    const auto s = p.is_list() ? std::nullopt : slot_of(p.name);
    if (!s || present[*s]) continue;
    slots_[i] = s;
    present[*s] = true;
    if (*s >= colour_slot) {
      colour_scale_[*s - colour_slot] = colour_scale(p.type);
      srgb_ = srgb_ || is_integer(p.type);
    }
  }
  const auto all = [&](std::size_t first, std::size_t count) {
    return std::all_of(present.begin() + static_cast<std::ptrdiff_t>(first),
                       present.begin() + static_cast<std::ptrdiff_t>(first + count), [](bool b) { return b; });
  };
  if (!all(0, 3)) throw Error({name, vertex.line, 1}, "the vertices have no x, y and z");
  has_normal_ = all(normal_slot, 3), has_uv_ = all(uv_slot, 2), has_colour_ = all(colour_slot, 3);
}

void VertexLayout::allocate(TriangleMesh& mesh, std::size_t count) const {
  mesh.positions.resize(count);
  if (has_normal_) mesh.normals.resize(count);
  if (has_uv_) mesh.uvs.resize(count);
  if (has_colour_) mesh.colours.resize(count);
}

void VertexLayout::store(TriangleMesh& mesh, std::size_t i, const std::array<float, slot_count>& values) const {
  mesh.positions[i] = {values[0], values[1], values[2]};
  if (has_normal_) mesh.normals[i] = {values[3], values[4], values[5]};
  if (has_uv_) mesh.uvs[i] = {values[6], values[7]};
  if (has_colour_) {
    Vec4 c;
    for (int k = 0; k < 4; ++k) {
      c[k] = values[colour_slot + static_cast<std::size_t>(k)] * colour_scale_[static_cast<std::size_t>(k)];
      if (srgb_ && k < 3) c[k] = srgb_decode(c[k]);
    }
    mesh.colours[i] = c;
  }
}

std::vector<std::string> VertexLayout::ignored() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (!slots_[i]) names.push_back(element_.properties[i].name);
  }
  return names;
}

void check_finite(const TriangleMesh& mesh, const std::string& name) {
  const auto fail = [&](std::size_t i, const char* what) {
    throw Error(name + ": vertex " + std::to_string(i) + ": its " + what + " is not finite");
  };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 p = mesh.positions[i];
    if (!is_finite(p)) fail(i, "position");
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const Vec3 n = mesh.normals[i];
    if (!is_finite(n)) fail(i, "normal");
  }
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
    if (!std::isfinite(mesh.uvs[i].x) || !std::isfinite(mesh.uvs[i].y)) fail(i, "texture coordinate");
  }
}

}  // namespace lambert::ply
