#include "command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace lambert::cli {
namespace {

std::string long_options(const CLI::App& app, const char* separator) {
  std::string words;
  for (const CLI::Option* o : app.get_options())
    for (const std::string& name : o->get_lnames()) words += (words.empty() ? "" : separator) + ("--" + name);
  return words;
}

std::vector<const CLI::App*> commands(const CLI::App& root) {
  return root.get_subcommands([](const CLI::App*) { return true; });
}

void print_bash(const CLI::App& root) {
  std::string names, cases;
  for (const CLI::App* sub : commands(root)) {
    names += sub->get_name() + " ";
    cases += fmt::format("    {}) words=\"{}\" ;;\n", sub->get_name(), long_options(*sub, " "));
  }
  fmt::print(R"(_lambert() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
  case "${{COMP_WORDS[1]}}" in
{}    *) words="{}--help --version" ;;
  esac
  if [[ $COMP_CWORD == 1 || $word == -* ]]; then COMPREPLY=($(compgen -W "$words" -- "$word"))
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
    for (const CLI::Option* o : sub->get_options())
      for (const std::string& name : o->get_lnames())
        fmt::print("complete -c lambert -n '__fish_seen_subcommand_from {}' -l {}\n", sub->get_name(), name);
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
