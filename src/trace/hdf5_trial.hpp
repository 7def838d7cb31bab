#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "trace/handover.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/trial.hpp"

namespace fingerpad {

/// How many children may try to read a file, one after another, where one waits for ever. GCC 12's address
/// sanitizer does not see to its allocator's locks when a process forks, as the C library does: a child that
/// is born while another thread has one waits for nobody.
int hdf5_trials() noexcept;

/// Reads an HDF5 file in a child process, for HDF5 1.10 trusts what it reads: of files with a few bytes
/// changed among its own records, one in thirty crashed it and one in ninety hung it; and anyone can put a
/// right seal under such a file.
/// @param told_bytes  that the child may tell in all
/// @param tell_all    in the child: (Teller&), ends with a flush
/// @param hear_all    here: (Hearer&) -> what is read
/// Throws Error (refused) where the file cannot be read to its end, or unfolds to more than `told_bytes`.
template <typename TellAll, typename HearAll>
std::invoke_result_t<const HearAll&, Hearer&> read_in_trial(const std::string& path,
                                                            const TrialLimits& limits,
                                                            std::uint64_t told_bytes, const TellAll& tell_all,
                                                            const HearAll& hear_all) {
  const auto work = [&](const Trial::Say& say) {
    Teller tell(say);
    tell_all(tell);
  };
  for (int trials_left = hdf5_trials();;) {
    std::optional<hdf5::Turn> turn(std::in_place);  // no other thread is amid HDF5 when the child is born
    Trial trial(work, limits);
    turn.reset();
    std::optional<std::invoke_result_t<const HearAll&, Hearer&>> heard;
    try {
      Hearer hear([&trial](std::span<char> out) { return trial.hear(out); }, told_bytes);
      heard = hear_all(hear);
    } catch (const ToldTooMuch&) {
      throw refused(path, "is damaged: it unfolds to more than a file of its size can hold");
    } catch (const ToldTooLittle&) {  // how it ended says why
    }
    const TrialOutcome outcome = trial.end();
    if (outcome.end == TrialOutcome::End::waited && --trials_left > 0) continue;
    if (outcome.end == TrialOutcome::End::threw) throw refused("", outcome.message);
    if (outcome.end == TrialOutcome::End::waited)
      throw refused(path,
                    fmt::format("cannot be read: it was not read within {} seconds; does the disk that it "
                                "is on answer?",
                                wait_seconds(limits)));
    if (outcome.end == TrialOutcome::End::died || !heard)
      throw refused(path, "is damaged: HDF5 cannot read it to its end");
    return *std::move(heard);
  }
}

}  // namespace fingerpad
