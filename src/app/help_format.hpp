#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fingerpad {

/// How `--help` is laid out: what each option takes and is about (option_words), no line longer than the
/// terminal is wide.
class HelpFormat final : public CLI::Formatter {
 public:
  /// @param width  letters a line
  explicit HelpFormat(std::size_t width) : width_(width) {}

  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_footer(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  std::string entry(const std::string& name, const std::string& words) const;

  std::size_t width_;
};

/// Letters a line of standard output: of a terminal its own, within what can be read; else 100.
std::size_t help_width();

}  // namespace fingerpad
