#include "command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <set>
#include <sstream>
#include <string>

namespace lambert::cli {
namespace {

/// What may follow a command: its own flags, its verbs and their flags, each once.
std::string words_of(const CLI::App& app) {
  std::set<std::string> words;
  const auto add = [&](const CLI::App& a) {
    for (const CLI::Option* o : a.get_options())
      for (const std::string& name : o->get_lnames()) words.insert("--" + name);
  };
  add(app);
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    words.insert(verb->get_name());
    add(*verb);
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::vector<const CLI::App*> commands(const CLI::App& root) {
  return root.get_subcommands([](const CLI::App*) { return true; });
}

void print_bash(const CLI::App& root) {
  std::string names, cases;
  for (const CLI::App* sub : commands(root)) {
    names += sub->get_name() + " ";
    cases += fmt::format("    {}) words=\"{}\" ;;\n", sub->get_name(), words_of(*sub));
  }
  fmt::print(R"(_lambert() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
  case "${{COMP_WORDS[1]}}" in
{}    *) words="{}--help --version" ;;
  esac
  if [[ $COMP_CWORD == 1 || $word == -* || ($COMP_CWORD == 2 && ${{COMP_WORDS[1]}} == polygon) ]]; then COMPREPLY=($(compgen -W "$words" -- "$word"))
  else COMPREPLY=($(compgen -f -- "$word")); fi
}}
complete -o filenames -F _lambert lambert
)",
             cases, names);
}

void print_zsh(const CLI::App& root) {
  fmt::print("autoload -U +X bashcompinit && bashcompinit\n");
  print_bash(root);
}

void print_fish(const CLI::App& root) {
  for (const CLI::App* sub : commands(root)) {
    fmt::print("complete -c lambert -n __fish_use_subcommand -a {} -d '{}'\n", sub->get_name(), sub->get_description());
    std::istringstream words(words_of(*sub));
    for (std::string word; words >> word;)
      fmt::print("complete -c lambert -n '__fish_seen_subcommand_from {}' {} {}\n", sub->get_name(),
                 word.starts_with("--") ? "-l" : "-a", word.starts_with("--") ? word.substr(2) : word);
  }
}

}  // namespace

std::function<int()> add_completion(CLI::App& app) {
  static std::string shell;
  app.add_option("shell", shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  app.footer("Example: lambert completion bash > /etc/bash_completion.d/lambert");
  return [&app] {
    const CLI::App& root = *app.get_parent();
    if (shell == "bash") print_bash(root);
    if (shell == "zsh") print_zsh(root);
    if (shell == "fish") print_fish(root);
    return done;
  };
}

}  // namespace lambert::cli
