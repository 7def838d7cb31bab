#pragma once

#include <cstddef>
#include <string>

namespace fingerpad {

/// A one-line bar on standard error that shows how many of a known number of jobs are done. Says nothing if
/// not shown.
class ProgressBar {
 public:
  ProgressBar(std::size_t total, bool shown) : total_(total), shown_(shown) {}
  /// One more job is done; `what` names it.
  void advance(const std::string& what);
  /// Ends the line.
  void finish();

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_;
};

}  // namespace fingerpad
