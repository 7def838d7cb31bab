#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fingerpad {

/// The man page of the program (roff), or of one of its subcommands, from what `--help` says.
std::string man_page(const CLI::App& program, const CLI::App& page_of);

/// What bash completes: subcommands, their options, the words that an option takes, keys of a scene.
std::string bash_completion(const CLI::App& program);

/// Writes fingerpad.1, a page a subcommand, and fingerpad.bash into a folder. Throws Error as OutputFile
/// does.
void write_manual(const CLI::App& program, const std::string& folder);

}  // namespace fingerpad
