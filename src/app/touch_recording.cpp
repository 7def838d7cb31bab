#include "app/touch_recording.hpp"

#include <filesystem>

#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "base/printable_text.hpp"
#include "replay/batch_files.hpp"
#include "replay/run_job.hpp"
#include "trace/trace_info.hpp"

namespace fingerpad {

std::unique_ptr<LiveRecorder> start_recording(const std::string& path, const Scene& scene, const World& world,
                                              const LiveDevice& device, TouchSwap& swap) {
  if (path.empty()) return nullptr;
  const TraceFormat format = path.ends_with(".csv") ? TraceFormat::csv : TraceFormat::hdf5;
  refuse_overwriting(path, input_files(scene));
  TraceInfo info = trace_info(scene, world, std::string(program_version));
  info.motion_file.clear();  // the person's, not the scene's
  info.motion_hash.clear();
  info.sent = device.has_motors();
  LiveRecorder::Watch watch;
  watch.place_fault = [path] {
    std::error_code ignored;
    const bool there =
        std::filesystem::exists(path, ignored) || std::filesystem::exists(path + ".part", ignored);
    return there ? std::string() : path + ": the file, or its folder, was removed";
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
  if (!force && std::filesystem::is_regular_file(path, ignored)) {
    throw Error(ErrorKind::usage, path,
                "exists already; --force writes over it, or give --record another name");
  }
}

/// A tick as its trace keeps it: with what a device with motors got of the force.
TickRecord as_recorded(TickRecord tick, const LiveDevice& device) noexcept {
  if (device.has_motors()) tick.sent_W_n = device.sent_W_n();
  return tick;
}

}  // namespace fingerpad
