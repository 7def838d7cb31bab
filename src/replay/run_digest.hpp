#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trace/trace.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {

/// What decides a trace's bytes, by kinds of things, so that it can be told which of them has changed.
struct RunDigest {
  /// One kind of them, as 16 hex digits.
  struct Kind {
    std::string_view name;
    std::string hash;
  };
  std::string whole;  ///< all of it, as 16 hex digits
  std::vector<Kind> kinds;
};

/// Everything that decides a trace's bytes: among it this very program (build_identity), but not the
/// libraries that it finds on its machine.
RunDigest run_digest(const TraceInfo& info, TraceFormat format);

/// That one kind of things is another than when a trace was made: "a mesh file has changed since".
/// @param kind  RunDigest::Kind::name
std::string changed_words(std::string_view kind);

}  // namespace fingerpad
