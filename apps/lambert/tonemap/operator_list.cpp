#include "options.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lambert::cli {

void print_operators(bool json) {
  nlohmann::ordered_json all = nlohmann::json::array();
  for (const std::string& name : tone_operator_names()) {
    ToneOperator op = tone_operator(name);
    const SettingTable table = tone_operator_settings(op);
    nlohmann::ordered_json settings = nlohmann::json::array();
    if (!json) fmt::print("{}\n  {}\n", name, tone_operator_summary(op));
    for (const Setting& s : table.settings()) {
      if (!json) fmt::print("  --set {}={:<10} {}\n", s.key, to_string(s), s.help);
      settings.push_back({{"key", s.key}, {"default", to_string(s)}, {"help", s.help}});
    }
    all.push_back({{"name", name}, {"summary", tone_operator_summary(op)}, {"settings", settings}});
  }
  if (json) fmt::print("{}\n", all.dump(2));
}

}  // namespace lambert::cli
