#pragma once

#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace fingerpad {

/// What the chosen subcommand does; its result is the program's exit code.
using Action = std::function<int()>;

/// A subcommand: adds itself to the command line and, when chosen, sets `action`.
using AddCommand = void (*)(CLI::App& program, Action& action);

void add_check(CLI::App& program, Action& action);
void add_query(CLI::App& program, Action& action);
void add_replay(CLI::App& program, Action& action);
void add_touch(CLI::App& program, Action& action);
void add_view(CLI::App& program, Action& action);
void add_plot(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_merge(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_keys(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_study(CLI::App& program, Action& action);
void add_fit(CLI::App& program, Action& action);

inline constexpr std::string_view program_version = FINGERPAD_VERSION;

}  // namespace fingerpad
