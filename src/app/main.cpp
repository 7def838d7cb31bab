#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <clocale>
#include <sstream>

#include "app/commands.hpp"
#include "app/manual.hpp"
#include "app/standard_streams.hpp"
#include "app/version_words.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"
#include "scene/toml_table.hpp"

namespace {

constexpr fingerpad::AddCommand commands[] = {
    fingerpad::add_check, fingerpad::add_query, fingerpad::add_replay,  fingerpad::add_export,
    fingerpad::add_study, fingerpad::add_merge, fingerpad::add_compare, fingerpad::add_keys,
    fingerpad::add_fit,
#ifdef FINGERPAD_VIEW
    fingerpad::add_touch, fingerpad::add_view,  fingerpad::add_plot,    fingerpad::add_report,
#endif
};

constexpr const char* description =
    "fingerpad: touch CAD surfaces with a finger pad's stick-slip friction.\n"
    "Imports a mesh, follows a finger over it tick by tick, and records, plots and shows every contact.\n"
    "Units are SI; a mesh's own unit is named by its scene or by --unit.";

constexpr const char* footer =
    "Exit codes: 0 done, 1 fault of the program, 2 usage, 3 an input was refused, 4 a batch finished with "
    "failed jobs, or what is compared differs.\n"
    "`fingerpad SUBCOMMAND --help` tells each subcommand's options, defaults and units.";

int report(const char* what, int code) {
  fingerpad::print_err("fingerpad: error: {}\n", what);
  return code;
}

/// "there is no subcommand 'repaly'; did you mean 'replay'?", or nothing where the first word is one.
std::string unknown_subcommand(const CLI::App& program, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  const auto* const end = argv + argc;
  const auto* const word = std::find_if(argv + 1, argv + argc, [](const char* arg) { return arg[0] != '-'; });
  if (word == end || std::find(names.begin(), names.end(), *word) != names.end()) return {};
  const std::string nearest = fingerpad::nearest_word(*word, names);
  return fmt::format("there is no subcommand '{}'{}; there are {}", fingerpad::printable(*word, 60),
                     nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
                     fingerpad::word_list(names));
}

int run(int argc, char** argv) {
  CLI::App program(description, "fingerpad");
  program.footer(footer);
  program.set_version_flag("--version", [] { return fingerpad::version_words(); });
  std::string manual_folder;
  program.add_option("--write-manual", manual_folder, "Write man pages and bash completion into a folder")
      ->group("");
  program.get_formatter()->column_width(34);
  fingerpad::Action action;
  for (const fingerpad::AddCommand add : commands) add(program, action);
  // The build asks for these pages (no user does), and no subcommand goes with them.
  program.require_subcommand(argc == 3 && std::string_view(argv[1]) == "--write-manual" ? 0 : 1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and --version
      std::ostringstream out;
      const int code = program.exit(error, out, out);
      fingerpad::write_stream(stdout, out.str());
      return code;
    }
    const std::string unknown = unknown_subcommand(program, argc, argv);
    report(unknown.empty() ? error.what() : unknown.c_str(), 0);
    fingerpad::print_err("Run with --help for the options.\n");
    return static_cast<int>(fingerpad::ErrorKind::usage);
  }
  if (!manual_folder.empty()) {
    fingerpad::write_manual(program, manual_folder);
    return 0;
  }
  return action();
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
  return fingerpad::close_standard_streams(told_run(argc, argv));
}
