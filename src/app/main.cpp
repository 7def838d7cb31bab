#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <clocale>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/commands.hpp"
#include "app/help_format.hpp"
#include "app/manual.hpp"
#include "app/number_option.hpp"
#include "app/option_words.hpp"
#include "app/standard_streams.hpp"
#include "app/version_words.hpp"
#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "base/printable_text.hpp"

namespace {

constexpr fingerpad::AddCommand commands[] = {
    fingerpad::add_check, fingerpad::add_query, fingerpad::add_replay,  fingerpad::add_export,
    fingerpad::add_study, fingerpad::add_merge, fingerpad::add_compare, fingerpad::add_keys,
    fingerpad::add_fit,   fingerpad::add_touch,
#ifdef FINGERPAD_VIEW
    fingerpad::add_view,  fingerpad::add_plot,  fingerpad::add_report,
#endif
};

constexpr const char* description =
    "fingerpad: touch CAD surfaces with a finger pad's stick-slip friction.\n"
    "Imports a mesh, follows a finger over it tick by tick, and records, plots and shows every contact.\n"
    "Units are SI; a mesh's own unit is named by its scene or by --unit.";

constexpr const char* footer =
    "Exit codes: 0 done, 1 fault of the program, 2 usage, 3 an input was refused, 4 a batch finished with "
    "failed jobs, or what is compared differs.\n"
    "`fingerpad SUBCOMMAND --help`, or `fingerpad help SUBCOMMAND`, tells each subcommand's options, "
    "defaults and units.";

int report(const char* what, int code) {
  fingerpad::print_err("fingerpad: error: {}\n", what);
  return code;
}

/// "there is no subcommand 'repaly'; did you mean 'replay'?", or which there are; nothing where the first
/// word is one.
std::string unknown_subcommand(const CLI::App& program, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  const auto* const end = argv + argc;
  const auto* const word = std::find_if(argv + 1, argv + argc, [](const char* arg) { return arg[0] != '-'; });
  if (word == end || std::find(names.begin(), names.end(), *word) != names.end()) return {};
  const std::string hint = fingerpad::near_miss_hint(*word, names);
  return fmt::format("there is no subcommand '{}'{}", fingerpad::printable(*word, 60),
                     hint.empty() ? "; there are " + fingerpad::word_list(names) : hint);
}

/// "there is no option '--colums'; did you mean '--columns'?", or which there are; nothing where the
/// subcommand, or the program without one, knows them all.
std::string unknown_option(const CLI::App& program, int argc, char** argv) {
  const CLI::App& command = program.get_subcommands().empty() ? program : *program.get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (&command == &program && option->get_group().empty()) continue;  // the build's own
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    if (word == "--") break;  // what follows is no option
    const std::string name(word.substr(0, word.find('=')));
    if (!name.starts_with("--") || std::find(names.begin(), names.end(), name) != names.end()) continue;
    std::string hint = fingerpad::near_miss_hint(name, names);
    // What other subcommands write by --out a window writes by this.
    const bool has_png = std::find(names.begin(), names.end(), "--png") != names.end();
    if (has_png && (name == "--out" || name == "--output")) hint = "; did you mean '--png'?";
    const std::string there = fmt::format("; {} has {}", command.get_name(), fingerpad::word_list(names));
    return fmt::format("there is no option '{}'{}", fingerpad::printable(name, 60),
                       hint.empty() ? there : hint);
  }
  return {};
}

/// "touch takes one SUBJECT: 'motions' is one too many"; "" where nothing is left over.
std::string one_too_many(const CLI::App& program) {
  const std::vector<std::string> extras = program.remaining(true);
  if (program.get_subcommands().empty() || extras.empty()) return {};
  const CLI::App& command = *program.get_subcommands().front();
  std::vector<std::string> takes;
  for (const CLI::Option* option : fingerpad::shown_options(command, true))
    takes.push_back("one " + option->get_name());
  const std::string words =
      fmt::format("{} takes {}: '{}' is one too many", command.get_name(),
                  takes.empty() ? "options alone" : fmt::format("{}", fmt::join(takes, " and ")),
                  fingerpad::printable(extras.front(), 60));
  const bool is_touch = command.get_name() == "touch";
  return is_touch
             ? words + "; the recording that --device recorded follows is named in the scene ([motion] file)"
             : words;
}

/// What is told of a command line that is not understood: a word that is spelled wrong before what is missing
/// for it.
std::string words_of(const CLI::ParseError& error, const CLI::App& program, int argc, char** argv) {
  const std::string command = unknown_subcommand(program, argc, argv);
  if (!command.empty()) return command;
  const auto* const no_number = dynamic_cast<const CLI::ConversionError*>(&error);
  if (no_number != nullptr && !program.get_subcommands().empty())
    return fingerpad::no_number_words(*no_number, *program.get_subcommands().front());
  const bool may_be_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                              dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const std::string option = may_be_unknown ? unknown_option(program, argc, argv) : "";
  if (!option.empty()) return option;
  const std::string extra = dynamic_cast<const CLI::ExtrasError*>(&error) ? one_too_many(program) : "";
  return extra.empty() ? error.what() : extra;
}

int run(int argc, char** argv) {
  CLI::App program(description, "fingerpad");
  program.footer(footer);
  program.set_version_flag("--version", [] { return fingerpad::version_words(); });
  std::string manual_folder;
  program.add_option("--write-manual", manual_folder, "Write man pages and bash completion into a folder")
      ->group("");
  program.formatter(std::make_shared<fingerpad::HelpFormat>(fingerpad::help_width()));
  fingerpad::Action action;
  for (const fingerpad::AddCommand add : commands) add(program, action);
  // The build asks for these pages (no user does), and no subcommand goes with them.
  program.require_subcommand(argc == 3 && std::string_view(argv[1]) == "--write-manual" ? 0 : 1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0 &&
        unknown_subcommand(program, argc, argv).empty()) {  // --help and --version
      std::ostringstream out;
      const int code = program.exit(error, out, out);
      fingerpad::write_stream(stdout, out.str());
      return code;
    }
    report(words_of(error, program, argc, argv).c_str(), 0);
    fingerpad::print_err("Run with --help for the options.\n");
    return static_cast<int>(fingerpad::ErrorKind::usage);
  }
  if (!manual_folder.empty()) {
    fingerpad::write_manual(program, manual_folder);
    return 0;
  }
  return action();
}

/// What `help view` asks for: `view --help`.
std::vector<char*> with_help_as_option(std::span<char*> arguments) {
  static char help[] = "--help";
  std::vector<char*> words(arguments.begin(), arguments.end());
  if (words.size() < 2 || std::string_view(words[1]) != "help") return words;
  words.erase(words.begin() + 1);
  if (words.size() > 2) words.resize(2);  // what follows the subcommand asks for nothing
  words.push_back(help);
  return words;
}

/// run(), with whatever it throws told.
int told_run(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const fingerpad::Error& error) {
    return report(error.what(), static_cast<int>(error.kind()));
  } catch (const std::bad_alloc&) {
    return report("out of memory", static_cast<int>(fingerpad::ErrorKind::fault));
  } catch (const std::exception& error) {
    return report(error.what(), static_cast<int>(fingerpad::ErrorKind::fault));
  }
}

}  // namespace

int main(int argc, char** argv) {
  fingerpad::guard_standard_streams();
  std::setlocale(LC_ALL, "C");  // decimal points, whatever the desktop speaks
  std::vector<char*> words = with_help_as_option({argv, static_cast<std::size_t>(argc)});
  return fingerpad::close_standard_streams(told_run(static_cast<int>(words.size()), words.data()));
}
