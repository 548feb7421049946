#include "command.h"

#include "lambert/render/method.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {
namespace {

nlohmann::ordered_json describe(const std::string& name) {
  const auto method = make_method(name);
  const MethodInfo info = method->info();
  nlohmann::ordered_json settings = nlohmann::json::array();
  const SettingTable table = method->settings();
  for (const Setting& s : table.settings())
    settings.push_back({{"key", s.key}, {"default", to_string(s)}, {"help", s.help}, {"choices", s.choices}});
  return {{"name", info.name},
          {"summary", info.summary},
          {"light_paths", info.light_paths},
          {"unbiased", info.unbiased},
          {"settings", settings}};
}

void print_text() {
  for (const std::string& name : method_names()) {
    const auto method = make_method(name);
    const MethodInfo info = method->info();
    fmt::print("{}\n  {}\n  light paths {}, {}\n", info.name, info.summary, info.light_paths,
               info.unbiased ? "unbiased" : "biased");
    const SettingTable table = method->settings();
    for (const Setting& s : table.settings()) fmt::print("  --set {}={:<10} {}\n", s.key, to_string(s), s.help);
  }
}

}  // namespace

std::function<int()> add_methods(CLI::App& app) {
  static bool json = false;
  app.add_flag("--json", json, "Print JSON");
  return [] {
    if (!json) {
      print_text();
      return done;
    }
    nlohmann::ordered_json all = nlohmann::json::array();
    for (const std::string& name : method_names()) all.push_back(describe(name));
    fmt::print("{}\n", all.dump(2));
    return done;
  };
}

}  // namespace lambert::cli
