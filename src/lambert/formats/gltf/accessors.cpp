#include "lambert/formats/gltf/accessors.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace lambert::gltf {
namespace {

std::size_t components_of(const JsonView& place) {
  static constexpr std::array<std::pair<std::string_view, std::size_t>, 7> types{
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
  const std::string name = place.text();
  std::vector<std::string> known;
  for (const auto& [type, components] : types) {
    if (name == type) return components;
    known.emplace_back(type);
  }
  place.fail("unknown type " + unknown_word(name, known));
}

void expect_unsigned(ComponentType type, const JsonView& place) {
  if (type.code != 5121 && type.code != 5123 && type.code != 5125)
    place.fail("expected unsigned integers (5121, 5123 or 5125), found " + std::to_string(type.code));
}

}  // namespace

Accessor::Accessor(const JsonView& root, const JsonView& reference, Buffers& buffers, Budget& budget)
    : json_(referred(root, "accessors", reference)), budget_(&budget) {
  dense_.count = json_["count"].count();
  dense_.components = components_of(json_["type"]);
  dense_.type = component_type(json_["componentType"]);
  dense_.normalized = json_["normalized"].boolean(false);
  if (dense_.count > 0xffffffffu) json_["count"].fail("expected less than 2^32");
  if (json_["bufferView"]) {
    const BufferView view = buffers.view(json_["bufferView"]);
    dense_.stride = view.stride;
    dense_.lay_over(view.bytes, json_["byteOffset"].count(0), json_);
  }
  if (json_["sparse"]) read_sparse_part(buffers);
}

void Accessor::read_sparse_part(Buffers& buffers) {
  const JsonView json = json_["sparse"], indices = json["indices"], values = json["values"];
  Sparse sparse;
  sparse.values = dense_;
  sparse.values.stride = 0;
  sparse.values.count = sparse.indices.count = json["count"].count();
  sparse.values.lay_over(buffers.view(values["bufferView"]).bytes, values["byteOffset"].count(0), values);
  sparse.indices.type = component_type(indices["componentType"]);
  expect_unsigned(sparse.indices.type, indices["componentType"]);
  sparse.indices.lay_over(buffers.view(indices["bufferView"]).bytes, indices["byteOffset"].count(0), indices);
  sparse_ = sparse;
}

void Accessor::expect_components(std::size_t n) const {
  if (components() != n)
    json_["type"].fail("expected " + std::to_string(n) + " components, found " + std::to_string(components()));
}

std::vector<float> Accessor::floats(const Selection& selection) const {
  const std::size_t elements = selection.empty() ? count() : selection.size();
  budget_->charge(elements, components() * sizeof(float), json_["count"]);
  std::vector<float> out(elements * components());
  dense_.read(selection, out);
  if (sparse_) replace(selection, out);
  const auto bad = std::find_if(out.begin(), out.end(), [](float f) { return !std::isfinite(f); });
  if (bad != out.end()) {
    const std::size_t element = static_cast<std::size_t>(bad - out.begin()) / components();
    fail("element " + std::to_string(selection.empty() ? element : selection[element]) + " is not finite");
  }
  return out;
}

void Accessor::replace(const Selection& selection, std::span<float> out) const {
  const JsonView json = json_["sparse"];
  budget_->charge(sparse_->values.count, (components() + 1) * sizeof(float), json["count"]);
  const std::vector<std::uint32_t> indices = sparse_->indices.integers();
  std::vector<float> values(sparse_->values.count * components());
  sparse_->values.read({}, values);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::size_t to = indices[i];
    if (to >= count())
      json["indices"].fail("index " + std::to_string(to) + " is out of range: there are " + std::to_string(count()) +
                           " elements");
    if (!selection.empty()) {
      const auto found = std::lower_bound(selection.begin(), selection.end(), indices[i]);
      if (found == selection.end() || *found != indices[i]) continue;
      to = static_cast<std::size_t>(found - selection.begin());
    }
    const auto value = std::span(values).subspan(i * components(), components());
    std::copy(value.begin(), value.end(), out.subspan(to * components()).begin());
  }
}

std::vector<std::uint32_t> Accessor::integers() const {
  expect_components(1);
  expect_unsigned(type(), json_["componentType"]);
  budget_->charge(count(), sizeof(std::uint32_t), json_["count"]);
  return dense_.integers();
}

}  // namespace lambert::gltf
