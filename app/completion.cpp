#include "app/completion.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace scree::app {
namespace {

struct Flag {
  std::string name, what;
  bool takes_value = false;
  std::vector<std::string> values;  // to choose from; empty: anything
};

struct Command {
  std::string name, what;
  std::vector<Flag> flags;
  std::vector<Command> subcommands;
  std::string path;                 // "scree cases verify"
  std::vector<std::string> values;  // that its arguments are chosen from; empty: files
};

Command command_of(const CLI::App& app, const std::string& path, const Choices& choices) {
  const auto values = [&](const std::string& where) {
    const auto at = choices.find(where);
    return at == choices.end() ? std::vector<std::string>() : at->second;
  };
  Command out{app.get_name(), app.get_description(), {}, {}, path, values(path)};
  for (const CLI::Option* o : app.get_options())
    for (const std::string& name : o->get_lnames())
      out.flags.push_back(
          {"--" + name, o->get_description(), o->get_items_expected_max() > 0, values(path + " --" + name)});
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    out.subcommands.push_back(command_of(*sub, path + " " + sub->get_name(), choices));
  return out;
}

/// A command and all below it.
template <class Visitor>
void each(const Command& c, Visitor&& see) {
  see(c);
  for (const Command& s : c.subcommands) each(s, see);
}

/// The text with a backslash before every character of `special`.
std::string escaped(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// In single quotes, for bash and zsh.
std::string shell_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text)
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  return out + "'";
}

std::string words(const Command& c) {
  std::string out;
  for (const Command& s : c.subcommands) out += s.name + " ";
  for (const std::string& v : c.values) out += v + " ";
  for (const Flag& f : c.flags) out += f.name + " ";
  out.pop_back();
  return out;
}

std::string bash(const Command& scree) {
  std::string cases, options;
  each(scree, [&](const Command& c) {
    cases += fmt::format("    '{}') words='{}' ;;\n", c.path, words(c));
    for (const Flag& f : c.flags)
      if (!f.values.empty())
        options += fmt::format("    '{} {}') words='{}' ;;\n", c.path, f.name, fmt::join(f.values, " "));
  });
  return fmt::format(R"(# scree completion bash > ~/.local/share/bash-completion/completions/scree
_scree() {{
  local at=scree words='' word i
  for ((i = 1; i < COMP_CWORD && i < 3; i++)); do
    word=${{COMP_WORDS[i]}}
    case "$at $word" in
{}      *) break ;;
    esac
  done
  case $at in
{}  esac
  case "$at ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}")
}}
complete -o default -F _scree scree
)",
                     [&] {
                       std::string known;
                       for (const Command& c : scree.subcommands) {
                         known += fmt::format("      'scree {0}') at='scree {0}' ;;\n", c.name);
                         for (const Command& s : c.subcommands)
                           known += fmt::format("      'scree {0} {1}') at='scree {0} {1}' ;;\n", c.name, s.name);
                       }
                       return known;
                     }(),
                     cases, options);
}

std::string zsh_value(const Flag& f) {
  if (!f.takes_value) return {};
  return f.values.empty() ? std::string(":value:_files") : fmt::format(":value:({})", fmt::join(f.values, " "));
}

std::string zsh_arguments(const Command& c) {
  std::string out = "_arguments";
  for (const Flag& f : c.flags)
    out += fmt::format(" \\\n        {}",
                       shell_quoted(fmt::format("{}[{}]{}", f.name, escaped(f.what, "[]:\\"), zsh_value(f))));
  return out + " \\\n        " +
         shell_quoted(c.values.empty() ? std::string("*:file:_files")
                                       : fmt::format("*:word:({})", fmt::join(c.values, " ")));
}

std::string zsh_values(const Command& c) {
  std::string out = "_values command";
  for (const Command& s : c.subcommands)
    out += " \\\n        " + shell_quoted(fmt::format("{}[{}]", s.name, escaped(s.what, "[]:\\")));
  return out;
}

std::string zsh(const Command& scree) {
  std::string cases;
  for (const Command& c : scree.subcommands) {
    if (c.subcommands.empty()) {
      cases += fmt::format("      {})\n        {} ;;\n", c.name, zsh_arguments(c));
      continue;
    }
    cases += fmt::format("      {})\n        if (( CURRENT == 2 )); then\n        {}\n        return; fi\n", c.name,
                         zsh_values(c));
    cases += "        local second=$words[2]; shift words; (( CURRENT-- ))\n        case $second in\n";
    for (const Command& s : c.subcommands)
      cases += fmt::format("        {})\n        {} ;;\n", s.name, zsh_arguments(s));
    cases += "        esac ;;\n";
  }
  return fmt::format(R"(#compdef scree
# scree completion zsh > a folder of $fpath/_scree
_scree() {{
  local line state
  _arguments -C '1:command:->command' '*::argument:->argument'
  case $state in
    command)
        {} ;;
    argument)
      case $words[1] in
{}      esac ;;
  esac
}}
compdef _scree scree
)",
                     zsh_values(scree), cases);
}

std::string fish(const Command& scree) {
  std::string out = "# scree completion fish > ~/.config/fish/completions/scree.fish\n";
  const auto text = [](std::string_view what) { return "'" + escaped(what, "'\\") + "'"; };
  for (const Command& c : scree.subcommands) {
    out += fmt::format("complete -c scree -n __fish_use_subcommand -f -a {} -d {}\n", c.name, text(c.what));
    const std::string seen = fmt::format("'__fish_seen_subcommand_from {}'", c.name);
    for (const Command& s : c.subcommands)
      out += fmt::format("complete -c scree -n {} -f -a {} -d {}\n", seen, s.name, text(s.what));
    const auto flags = [&](const Command& of, const std::string& where) {
      for (const Flag& f : of.flags)
        out += fmt::format("complete -c scree -n {} -l {}{} -d {}\n", where, f.name.substr(2),
                           f.values.empty() ? std::string(f.takes_value ? " -r" : "")
                                            : fmt::format(" -x -a '{}'", fmt::join(f.values, " ")),
                           text(f.what));
      if (!of.values.empty())
        out += fmt::format("complete -c scree -n {} -f -a '{}'\n", where, fmt::join(of.values, " "));
    };
    flags(c, seen);
    for (const Command& s : c.subcommands)
      flags(s, fmt::format("'__fish_seen_subcommand_from {}; and __fish_seen_subcommand_from {}'", c.name, s.name));
  }
  return out;
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell, const Choices& choices) {
  const Command scree = command_of(app, "scree", choices);
  if (shell == "bash") return bash(scree);
  return shell == "zsh" ? zsh(scree) : fish(scree);
}

}  // namespace scree::app
