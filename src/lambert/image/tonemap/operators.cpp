#include "lambert/image/tonemap/operators.h"

#include "lambert/base/error.h"
#include "lambert/image/tonemap/tonemap.h"

#include <array>
#include <utility>

namespace lambert {
namespace {

template <class... Ops>
std::vector<ToneOperator> defaults(const std::variant<Ops...>*) {
  return {Ops{}...};
}
const std::vector<ToneOperator>& operators() {
  static const std::vector<ToneOperator> all = defaults(static_cast<const ToneOperator*>(nullptr));
  return all;
}

constexpr std::array<std::pair<std::string_view, ToneChannels>, 2> channel_choices{
    {{"luminance", ToneChannels::luminance}, {"rgb", ToneChannels::rgb}}};

}  // namespace

std::string tone_operator_name(const ToneOperator& op) {
  return std::visit([](const auto& o) -> std::string { return o.name; }, op);
}
std::string tone_operator_summary(const ToneOperator& op) {
  return std::visit([](const auto& o) -> std::string { return o.summary; }, op);
}
SettingTable tone_operator_settings(ToneOperator& op) {
  return SettingTable(std::visit([](auto& o) { return o.settings(); }, op));
}

ToneOperator tone_operator(std::string_view name) {
  for (const ToneOperator& op : operators())
    if (tone_operator_name(op) == name) return op;
  throw Error("unknown tone operator " + unknown_word(name, tone_operator_names()));
}

std::vector<std::string> tone_operator_names() {
  std::vector<std::string> names;
  for (const ToneOperator& op : operators()) names.push_back(tone_operator_name(op));
  return names;
}

ToneChannels tone_channels(std::string_view name) {
  for (const auto& [known, value] : channel_choices)
    if (known == name) return value;
  throw Error("unknown choice of channels " + unknown_word(name, tone_channels_names()));
}

std::vector<std::string> tone_channels_names() {
  std::vector<std::string> names;
  for (const auto& choice : channel_choices) names.emplace_back(choice.first);
  return names;
}

}  // namespace lambert
