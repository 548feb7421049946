#include "lambert/light/light_choice.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert {
namespace {

constexpr std::array strategies = {
    std::pair{std::string_view("uniform"), LightStrategy::uniform},
    std::pair{std::string_view("power"), LightStrategy::power},
    std::pair{std::string_view("tree"), LightStrategy::tree},
};

}  // namespace

LightStrategy light_strategy(std::string_view name) {
  for (const auto& [known, strategy] : strategies) {
    if (known == name) return strategy;
  }
  throw Error("unknown light strategy " + unknown_word(name, light_strategy_names()));
}

std::vector<std::string> light_strategy_names() {
  std::vector<std::string> names;
  for (const auto& entry : strategies) names.emplace_back(entry.first);
  return names;
}

LightChooser::LightChooser(std::span<const Light> lights, const LightContext& context, LightStrategy strategy)
    : light_count_(static_cast<std::uint32_t>(lights.size())), use_tree_(strategy == LightStrategy::tree) {
  if (light_count_ <= 1) return;
  std::vector<LightBounds> bounds;
  for (const Light& l : lights) bounds.push_back(light_bounds(l, context));
  if (!use_tree_) {
    std::vector<float> weights(lights.size(), 1.0f);
    if (strategy == LightStrategy::power) {
      std::transform(bounds.begin(), bounds.end(), weights.begin(), [](const LightBounds& b) { return b.power; });
    }
    table_.emplace(weights);
    return;
  }
  std::vector<std::uint32_t> finite;
  is_infinite_.resize(lights.size());
  for (std::uint32_t l = 0; l < light_count_; ++l) {
    if (!bounds[l].box.empty()) {
      finite.push_back(l);
    } else if (bounds[l].power > 0) {
      is_infinite_[l] = true;
      infinite_.push_back(l);
    }
  }
  tree_ = LightTree(bounds, std::move(finite));
  const std::size_t shares = infinite_.size() + (tree_.empty() ? 0 : 1);
  share_ = shares ? 1 / static_cast<float>(shares) : 0;
}

LightChooser::Choice LightChooser::choose_among_many(Vec3 point, Vec3 normal, float u) const {
  if (!use_tree_) {
    const auto [index, probability] = table_->sample(u);
    return {static_cast<std::uint32_t>(index), probability};
  }
  if (share_ == 0) return {};
  const float scaled = u / share_;  // shares of the lights at infinity come first
  if (const auto i = static_cast<std::size_t>(scaled); i < infinite_.size()) return {infinite_[i], share_};
  Choice c = tree_.choose(point, normal, std::min(scaled - static_cast<float>(infinite_.size()), one_minus_epsilon));
  c.probability *= share_;
  return c;
}

float LightChooser::probability_among_many(Vec3 point, Vec3 normal, std::uint32_t light) const {
  if (!use_tree_) return table_->probability(light);
  return is_infinite_[light] ? share_ : share_ * tree_.probability(point, normal, light);
}

}  // namespace lambert
