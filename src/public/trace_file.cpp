#include "fingerpad/trace_file.hpp"

#include "base/error.hpp"
#include "public/finger_impl.hpp"
#include "trace/trace_info.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {
namespace {

TraceFormat format_of(const std::string& path) {
  if (path.ends_with(".h5")) return TraceFormat::hdf5;
  if (path.ends_with(".csv")) return TraceFormat::csv;
  throw Error(ErrorKind::usage, path, "a trace is written as .h5 or .csv");
}

}  // namespace

struct TraceRecorder::Impl {
  std::shared_ptr<const World> world;
  std::unique_ptr<TraceWriter> writer;
};

TraceRecorder::TraceRecorder(const std::string& path, const Finger& finger) {
  const Finger::Impl& touched = *finger.impl_;
  const TraceFormat format = format_of(path);
  TraceInfo info = trace_info(touched.scene, *touched.world, FINGERPAD_VERSION);
  info.motion_file.clear();  // the caller's, not the scene's
  info.motion_hash.clear();
  impl_ = std::make_unique<Impl>();
  impl_->world = touched.world;
  impl_->writer = TraceWriter::create(path, format, info, *touched.world);
}

TraceRecorder::~TraceRecorder() = default;

void TraceRecorder::append(const TickRecord& record) {
  impl_->writer->append({&record, 1});
}

void TraceRecorder::flush() {
  impl_->writer->flush();
}

void TraceRecorder::finish() {
  impl_->writer->finish();
}

TraceFile read_trace_file(const std::string& path) {
  Trace trace = read_trace(path, TraceContents::rows);
  return {std::move(trace.rows), trace.complete, trace.info.rate_hz, std::move(trace.info.scene_name),
          std::move(trace.info.scene_text)};
}

}  // namespace fingerpad
