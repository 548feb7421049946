#include "verb_table.h"

#include "command.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace lambert::cli {

std::function<int()> add_verbs(CLI::App& app, std::span<const Verb> verbs) {
  app.require_subcommand(1);
  const auto entries = std::make_shared<std::vector<std::pair<CLI::App*, std::function<int()>>>>();
  for (const Verb& verb : verbs) {
    CLI::App* sub = app.add_subcommand(verb.name, verb.summary);
    entries->emplace_back(sub, verb.add(*sub));
  }
  return [entries] {
    for (const auto& [sub, run] : *entries)
      if (sub->parsed()) return run();
    return usage_error;
  };
}

}  // namespace lambert::cli
