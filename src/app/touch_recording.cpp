#include "app/touch_recording.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "base/printable_text.hpp"
#include "replay/batch_files.hpp"
#include "replay/run_job.hpp"
#include "trace/trace_info.hpp"

namespace fingerpad {
namespace {

/// What cannot be told, as where a network's folder does not answer for a moment, is not gone.
bool is_gone(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::status(path, ignored).type() == std::filesystem::file_type::not_found;
}

}  // namespace

std::unique_ptr<LiveRecorder> start_recording(const std::string& path, const Scene& scene, const World& world,
                                              const LiveDevice& device, TouchSwap& swap) {
  if (path.empty()) return nullptr;
  const TraceFormat format = path.ends_with(".csv") ? TraceFormat::csv : TraceFormat::hdf5;
  refuse_overwriting(path, input_files(scene));
  if (format == TraceFormat::csv)
    print_err(
        "fingerpad: {}: a CSV recording keeps neither the parts nor the scene, so that view shows its path "
        "alone; --record with a name that ends in .h5 keeps them\n",
        path);
  TraceInfo info = trace_info(scene, world, std::string(program_version));
  info.motion_file.clear();  // the person's, not the scene's
  info.motion_hash.clear();
  const SampleParts parts = device.gives();
  info.turning = parts.directions;
  info.attitudes = parts.attitudes;
  info.estimated = parts.velocities;
  info.in_hand = parts.pushes;
  info.sent = device.has_motors();
  LiveRecorder::Watch watch;
  watch.place_fault = [path] {
    return is_gone(path) && is_gone(path + ".part") ? path + ": the file, or its folder, was removed"
                                                    : std::string();
  };
  watch.changes = [&swap](std::size_t from) { return swap.taken(from); };
  watch.tell = [](const std::string& why) {
    print_err("fingerpad: warning: {}; the touch goes on, but is recorded no longer\n", why);
  };
  return std::make_unique<LiveRecorder>(TraceWriter::create(path, format, info, world), watch);
}

/// Before the touch, whose record could not be made again.
void refuse_unrecordable(const std::string& path, const Scene& scene, bool force) {
  if (path == "-") throw Error(ErrorKind::usage, "--record", "a trace needs a file, not standard output");
  if (!is_utf8(scene.text))
    throw Error(ErrorKind::usage, scene.name, "its name is not UTF-8, as a trace's must be: rename it");
  refuse_unwritable(path);
  std::error_code ignored;
  const auto refuse = [&](const std::string& file, const char* what) {
    if (force || !std::filesystem::is_regular_file(file, ignored)) return;
    throw Error(ErrorKind::usage, file,
                fmt::format("{}; --force writes over it, or give --record another name", what));
  };
  refuse(path, "exists already");
  refuse(path + ".part", "is of a recording by that name that was cut short or is still being written");
}

TickRecord as_recorded(TickRecord tick, const FingerSample& sample, const LiveDevice& device) noexcept {
  const SampleParts parts = device.gives();
  if (parts.directions) tick.direction_W = sample.direction_W;
  if (parts.attitudes) {
    const Attitude attitude = sample.attitude.value_or(Attitude::Identity());
    tick.attitude << attitude.w(), attitude.vec();
  }
  if (parts.pushes) {
    tick.encoded_W = sample.p_WQ;
    tick.push_W_n = sample.push_W_n;
  }
  if (const auto place_W = device.true_place_W()) tick.p_WQ = *place_W;
  if (device.has_motors()) tick.sent_W_n = device.sent_W_n();
  return tick;
}

}  // namespace fingerpad
