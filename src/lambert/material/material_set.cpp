#include "lambert/base/error.h"
#include "lambert/base/hash.h"
#include "lambert/material/material.h"

#include <algorithm>
#include <utility>

namespace lambert {
namespace {

std::string describe(const MaterialSet& set, MaterialId id) {
  const std::string& name = set[id].name;
  return name.empty() ? "material " + std::to_string(id) : "material '" + name + "'";
}

/// Depth-first search over mixes; what is on the present path must not be met again.
class CycleSearch {
 public:
  explicit CycleSearch(const MaterialSet& set) : set_(set), states_(set.size(), State::unseen) {}

  void visit(MaterialId root) {
    std::vector<MaterialId> path{root};
    while (!path.empty()) {
      const MaterialId id = path.back();
      if (states_[id] == State::unseen) {
        states_[id] = State::on_path;
        push_children(id, path);
      } else {
        states_[id] = State::done;
        path.pop_back();
      }
    }
  }

 private:
  enum class State : std::uint8_t { unseen, on_path, done };

  void push_children(MaterialId id, std::vector<MaterialId>& path) {
    const auto* mix = std::get_if<MixMaterial>(&set_[id].model);
    if (!mix) return;
    for (const MaterialId child : {mix->a, mix->b}) {
      if (child >= set_.size()) throw Error(describe(set_, id) + " mixes a material that does not exist");
      if (states_[child] == State::on_path) {
        throw Error(describe(set_, id) + " mixes " + describe(set_, child) + ", which is made of it");
      }
      if (states_[child] == State::unseen) path.push_back(child);
    }
  }

  const MaterialSet& set_;
  std::vector<State> states_;
};

}  // namespace

MaterialId MaterialSet::add(Material m) {
  materials_.push_back(std::move(m));
  return static_cast<MaterialId>(materials_.size() - 1);
}

MaterialId MaterialSet::resolve(MaterialId id, const TextureSet& textures, const TextureCoordinates& at,
                                std::uint64_t hash) const {
  while (const auto* mix = std::get_if<MixMaterial>(&materials_[id].model)) {
    id = hash_to_float(hash) < mix->amount.eval(textures, at) ? mix->b : mix->a;
    hash = mix_bits(hash + 0x9e3779b97f4a7c15ull);  // a mix of mixes decides anew
  }
  return id;
}

void MaterialSet::validate() const {
  CycleSearch search(*this);
  for (MaterialId id = 0; id < materials_.size(); ++id) search.visit(id);
}

}  // namespace lambert
