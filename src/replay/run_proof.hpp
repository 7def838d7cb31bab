#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/checksum.hpp"
#include "replay/run_digest.hpp"

namespace fingerpad {

/// Keeps beside a finished trace, in the state folder, which run made it, what its bytes are and what the run
/// came to: a CSV trace tells nothing of its run, and no trace tells all figures. Nothing of it depends on
/// when or how often the run was started. A proof that cannot be written is none: then the next `--resume`
/// makes the trace again.
/// @param trace  the sum of the file as it was written
void write_proof(const std::string& trace_path, const RunDigest& digest, const std::vector<double>& figures,
                 const FileSum& trace);
/// As above, of a trace that stands there already: its file is read.
void write_proof(const std::string& trace_path, const RunDigest& digest, const std::vector<double>& figures);

/// The figures of the trace at that path, if its proof says that it is of the run with this digest and the
/// file is, byte for byte, what that run wrote.
std::optional<std::vector<double>> proven_figures(const std::string& trace_path, const RunDigest& digest);

/// Whether the proof beside the trace names a run with another digest.
bool proves_another_run(const std::string& trace_path, const RunDigest& digest);

/// Whether a proof stands beside the trace, of whatever run.
bool has_proof(const std::string& trace_path);

/// Which build (short_build_identity) made the trace that the proof beside it is of; nothing where that is
/// this one, or no proof is there. "an earlier one" where the proof names none.
std::optional<std::string> other_build_of(const std::string& trace_path);

/// "another build of the program (12ab; this one is 34cd), and results of two builds are not mixed".
std::string other_build_words(const std::string& build);

/// Why a trace that stands there is made again, in words that go on after "made again: ".
struct MadeAgain {
  std::string why;              ///< empty: it was not, or no file was there
  bool of_other_build = false;  ///< because another build of the program had made it
};

/// Of the trace at that path, for the run with this digest. Of an HDF5 trace, which keeps its scene, what the
/// scene was and is now, in so far as scene_differences() tells it in few words.
/// @param scene_text    the run's, as its trace would keep it
/// @param is_countable  without a proof, a whole trace of this run would be kept for what it says of itself
/// @pre proven_figures() gives nothing
MadeAgain why_not_kept(const std::string& trace_path, const RunDigest& digest, const std::string& scene_text,
                       bool is_countable);

/// Removes what a killed run may have left beside a trace that is kept: files that were under way.
void remove_unfinished(const std::string& trace_path);

}  // namespace fingerpad
