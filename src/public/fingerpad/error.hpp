#pragma once

#include <stdexcept>
#include <string>

namespace fingerpad {

/// What went wrong, in the terms of the program's exit code.
enum class ErrorKind {
  fault = 1,    ///< the program's own failure (a disk that is full, a library that failed)
  usage = 2,    ///< the call makes no sense (options, no screen)
  refused = 3,  ///< an input cannot be used
};

/// The one exception of the project: a kind, a place (`bracket.stl: byte 84`, `scene.toml:12:5`) and what is
/// wrong there, with the mend where one is known. what() is "WHERE: WHAT".
class Error : public std::runtime_error {
 public:
  /// @param kind   as the exit code
  /// @param where  the place; may be empty
  /// @param what   what is wrong there
  Error(ErrorKind kind, const std::string& where, const std::string& what)
      : std::runtime_error(where.empty() ? what : where + ": " + what), kind_(kind) {}

  /// What a program that ends by it should return.
  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace fingerpad
