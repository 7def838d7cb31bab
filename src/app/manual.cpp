#include "app/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "app/option_words.hpp"
#include "scene/scene_key.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

/// Words as roff takes them: nothing in them is a request or an escape.
std::string roff(const std::string& words) {
  std::string text;
  bool line_begins = true;
  for (const char letter : words) {
    if (line_begins && (letter == '.' || letter == '\'')) text += "\\&";
    if (letter == '\\') {
      text += "\\e";
    } else if (letter == '-') {
      text += "\\-";
    } else {
      text += letter;
    }
    line_begins = letter == '\n';
  }
  return text;
}

/// A text of several lines keeps them.
std::string paragraph(const std::string& words) {
  if (words.find('\n') == std::string::npos) return roff(words) + "\n";
  return ".nf\n" + roff(words) + (words.ends_with('\n') ? "" : "\n") + ".fi\n";
}

std::string synopsis_of(const CLI::App& app) {
  std::string text = shown_options(app, false).empty() ? "" : " [\\fIOPTION\\fR]...";
  for (const CLI::Option* option : shown_options(app, true)) {
    const std::string many = option->get_items_expected_max() > 1 ? "..." : "";
    const std::string name = fmt::format("\\fI{}\\fR{}", roff(option->get_name(true)), many);
    text += option->get_required() ? " " + name : fmt::format(" [{}]", name);
  }
  return text;
}

std::string option_entry(const CLI::Option& option) {
  const std::string name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  std::string entry = fmt::format(".TP\n\\fB{}\\fR", roff(name));
  const std::string takes = option.get_positional() ? "" : placeholder(option);
  if (!takes.empty()) entry += fmt::format(" \\fI{}\\fR", roff(takes));
  return entry + "\n" + roff(about(option)) + "\n";
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const bool positional : {true, false}) {
    const auto options = shown_options(app, positional);
    if (!options.empty()) text += positional ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n";
    for (const CLI::Option* option : options) text += option_entry(*option);
  }
  return text;
}

constexpr const char* exit_status =
    ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nA fault of the program, or output was lost.\n.TP\n2\nUsage.\n"
    ".TP\n3\nAn input was refused.\n.TP\n4\nA batch finished with failed jobs, or what is compared "
    "differs.\n";

/// Bash's own quoting of a list of words.
std::string word_list_of(const std::vector<std::string>& words) {
  return fmt::format("'{}'", fmt::join(words, " "));
}

/// What stands between braces in what an option takes: "{h5,csv,none}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string takes = option.get_type_name();
  const std::size_t begin = takes.find('{'), end = takes.find('}');
  std::vector<std::string> words;
  if (begin == std::string::npos || end == std::string::npos) return words;
  for (const std::string& word : CLI::detail::split(takes.substr(begin + 1, end - begin - 1), ',')) {
    words.push_back(word.substr(0, word.find("->")));
  }
  return words;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::string completion_of(const CLI::App& command) {
  std::vector<std::string> options;
  std::string text = fmt::format("    {})\n      case $before in\n", command.get_name());
  for (const CLI::Option* option : shown_options(command, false)) {
    const std::vector<std::string> names = names_of(*option), words = choices_of(*option);
    options.insert(options.end(), names.begin(), names.end());
    if (words.empty()) continue;
    text += fmt::format("        {}) words={} ;;\n", fmt::join(names, "|"), word_list_of(words));
  }
  return text + fmt::format("      esac\n      options={} ;;\n", word_list_of(options));
}

}  // namespace

std::string man_page(const CLI::App& program, const CLI::App& page_of) {
  const bool whole = &program == &page_of;
  const std::string name = whole ? "fingerpad" : "fingerpad-" + page_of.get_name();
  const std::string about =
      whole ? "touch CAD surfaces with a finger pad's stick-slip friction" : page_of.get_description();
  std::string upper = name;
  for (char& letter : upper) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  std::string page =
      fmt::format(".TH {} 1 \"\" \"fingerpad {}\" \"User Commands\"\n", roff(upper), program_version);
  page += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B fingerpad{}\n", roff(name), roff(about),
                      whole ? "" : " " + roff(page_of.get_name()));
  page += whole ? "\\fISUBCOMMAND\\fR [\\fIOPTION\\fR]...\n"
                : synopsis_of(page_of).substr(synopsis_of(page_of).empty() ? 0 : 1) + "\n";
  if (whole) {
    page += ".SH DESCRIPTION\n" + paragraph(page_of.get_description()) + ".SH SUBCOMMANDS\n";
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
      page += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBfingerpad\\-{}\\fR(1)\n", roff(command->get_name()),
                          roff(command->get_description()), roff(command->get_name()));
    }
  }
  page += options_of(page_of);
  if (!whole && !page_of.get_footer().empty()) page += ".SH NOTES\n" + paragraph(page_of.get_footer());
  return page + exit_status + (whole ? "" : ".SH SEE ALSO\n\\fBfingerpad\\fR(1)\n");
}

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> commands, keys;
  std::string cases;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    commands.push_back(command->get_name());
    cases += completion_of(*command);
  }
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys) {
      const std::string name =
          table.name.empty() ? std::string(key.key) : fmt::format("{}.{}", table.name, key.key);
      if (std::find(keys.begin(), keys.end(), name) == keys.end()) keys.push_back(name);
    }
  }
  return fmt::format(R"(# bash completion for fingerpad, made from the program's own tables
_fingerpad() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words= options=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$word"))
    return
  fi
  case $command in
{}  esac
  [ "$command" != keys ] || words={}
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  else
    compopt -o filenames 2>/dev/null
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -F _fingerpad fingerpad
)",
                     word_list_of([&] {
                       auto all = commands;
                       all.insert(all.end(), {"--help", "--version"});
                       return all;
                     }()),
                     cases, word_list_of(keys));
}

void write_manual(const CLI::App& program, const std::string& folder) {
  const auto write = [&](const std::string& name, const std::string& text) {
    OutputFile file((std::filesystem::path(folder) / name).string());
    file.write(text);
    file.commit();
  };
  write("fingerpad.1", man_page(program, program));
  for (const CLI::App* command : program.get_subcommands(nullptr))
    write(fmt::format("fingerpad-{}.1", command->get_name()), man_page(program, *command));
  write("fingerpad.bash", bash_completion(program));
}

}  // namespace fingerpad
