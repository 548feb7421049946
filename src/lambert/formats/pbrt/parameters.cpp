#include "lambert/formats/pbrt/parameters.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::pbrt {
namespace {

constexpr std::array<const char*, 13> names{"integer",  "float", "point2",    "vector2", "point3", "vector3", "normal",
                                            "spectrum", "rgb",   "blackbody", "bool",    "string", "texture"};

std::string any_of(std::initializer_list<ParameterType> types) {
  std::string s;
  for (const ParameterType t : types) s += (s.empty() ? "'" : " or '") + std::string(type_name(t)) + "'";
  return s;
}

}  // namespace

const char* type_name(ParameterType t) { return names[static_cast<std::size_t>(t)]; }
std::vector<std::string> parameter_type_names() { return {names.begin(), names.end()}; }

void ParameterList::add(Parameter p) {
  if (has(p.name)) p.fail("parameter '" + p.name + "' is given twice");
  parameters_.push_back(std::move(p));
}

void ParameterList::inherit(const std::vector<Parameter>& defaults) {
  for (const Parameter& p : defaults) {
    if (!has(p.name)) parameters_.push_back(p);
  }
}

bool ParameterList::has(std::string_view name) const {
  return std::any_of(parameters_.begin(), parameters_.end(), [&](const Parameter& p) { return p.name == name; });
}

const Parameter* ParameterList::find(std::string_view name, std::initializer_list<ParameterType> allowed) const {
  const auto p = std::find_if(parameters_.begin(), parameters_.end(), [&](const auto& q) { return q.name == name; });
  if (p == parameters_.end()) return nullptr;
  p->used = true;
  if (std::find(allowed.begin(), allowed.end(), p->type) == allowed.end()) {
    p->fail("parameter '" + p->name + "' of " + owner_ + " has the type '" + type_name(p->type) + "', expected " +
            any_of(allowed));
  }
  return &*p;
}

const Parameter* ParameterList::find_single(std::string_view name, ParameterType type, std::size_t values) const {
  const Parameter* p = find(name, {type});
  const std::size_t found = p ? p->floats.size() + p->integers.size() + p->strings.size() : 0;
  if (p && found != values) {
    p->fail("parameter '" + p->name + "' of " + owner_ + " takes " + std::to_string(values) +
            (values == 1 ? " value" : " numbers") + ", found " + std::to_string(found));
  }
  return p;
}

float ParameterList::number(std::string_view name, float fallback) const {
  const Parameter* p = find_single(name, ParameterType::floating, 1);
  return p ? p->floats[0] : fallback;
}
int ParameterList::integer(std::string_view name, int fallback) const {
  const Parameter* p = find_single(name, ParameterType::integer, 1);
  return p ? p->integers[0] : fallback;
}
bool ParameterList::boolean(std::string_view name, bool fallback) const {
  const Parameter* p = find_single(name, ParameterType::boolean, 1);
  return p ? p->integers[0] != 0 : fallback;
}
std::string ParameterList::string(std::string_view name, std::string fallback) const {
  const Parameter* p = find_single(name, ParameterType::string, 1);
  return p ? p->strings[0] : std::move(fallback);
}
Vec3 ParameterList::point(std::string_view name, Vec3 fallback) const {
  const Parameter* p = find_single(name, ParameterType::point3, 3);
  return p ? Vec3(p->floats[0], p->floats[1], p->floats[2]) : fallback;
}

std::vector<float> ParameterList::numbers(std::string_view name) const {
  const Parameter* p = find(name, {ParameterType::floating});
  return p ? p->floats : std::vector<float>();
}
std::vector<int> ParameterList::integers(std::string_view name) const {
  const Parameter* p = find(name, {ParameterType::integer});
  return p ? p->integers : std::vector<int>();
}
std::vector<std::string> ParameterList::strings(std::string_view name) const {
  const Parameter* p = find(name, {ParameterType::string});
  return p ? p->strings : std::vector<std::string>();
}

std::vector<Vec3> ParameterList::vectors3(std::string_view name, ParameterType type) const {
  const Parameter* p = find(name, {type});
  std::vector<Vec3> v(p ? p->floats.size() / 3 : 0);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = {p->floats[3 * i], p->floats[3 * i + 1], p->floats[3 * i + 2]};
  return v;
}
std::vector<Vec2> ParameterList::vectors2(std::string_view name, ParameterType type) const {
  const Parameter* p = find(name, {type});
  std::vector<Vec2> v(p ? p->floats.size() / 2 : 0);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = {p->floats[2 * i], p->floats[2 * i + 1]};
  return v;
}

void ParameterList::note_unused(Notes& notes) const {
  for (const Parameter& p : parameters_) {
    if (p.used || p.inherited) continue;
    notes.add(SourceLocation(p.place).to_string() + ": unused parameter '" + p.name + "' of " + owner_);
  }
}

void ParameterList::ignore_all() const {
  for (const Parameter& p : parameters_) p.used = true;
}

}  // namespace lambert::pbrt
