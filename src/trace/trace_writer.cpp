#include "trace/trace_writer.hpp"

#include <utility>
#include <vector>

#include "base/error.hpp"
#include "touch/world.hpp"
#include "trace/change_log.hpp"
#include "trace/csv_rows.hpp"
#include "trace/embedded_surfaces.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/output_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t flushed_rows = 4096;

void write_info(const hdf5::Handle& file, const TraceInfo& info) {
  hdf5::write_flag(file, "complete", false);
  hdf5::write_text(file, "scene_name", info.scene_name);
  hdf5::write_text(file, "scene", info.scene_text);
  hdf5::write_whole(file, "seed", info.seed);
  hdf5::write_numbers(file, "rate_hz", std::span(&info.rate_hz, 1));
  hdf5::write_text(file, "version", info.version);
  hdf5::write_texts(file, "mesh_files", info.mesh_files);
  hdf5::write_texts(file, "mesh_hashes", info.mesh_hashes);
  hdf5::write_text(file, "motion_file", info.motion_file);
  hdf5::write_text(file, "motion_hash", info.motion_hash);
  hdf5::write_texts(file, "motion_notes", info.motion_notes);
  hdf5::write_text(file, "profile", info.profile_text);
  hdf5::write_text(file, "contact_method", info.contact_method);
  hdf5::write_text(file, "contact_normals", info.contact_normals);
  hdf5::write_texts(file, "contact_reasons", info.contact_reasons);
  if (!info.columns.empty()) hdf5::write_texts(file, "columns", info.columns);
  if (info.every != 1) hdf5::write_whole(file, "every", info.every);
}

/// The histograms of the whole run: bucket i counts what took up to its upper end and longer than the one
/// before.
void write_timing(const hdf5::Handle& file, const ServoTiming& timing) {
  std::vector<double> upper_s, tick_times, latenesses;
  for (int i = 0; i < TimeCounts::buckets; ++i) {
    upper_s.push_back(TimeCounts::upper_s(i));
    tick_times.push_back(static_cast<double>(timing.tick_times.counts[static_cast<std::size_t>(i)]));
    latenesses.push_back(static_cast<double>(timing.latenesses.counts[static_cast<std::size_t>(i)]));
  }
  hdf5::write_whole(file, "servo_ticks", static_cast<std::uint64_t>(timing.ticks));
  hdf5::write_whole(file, "servo_late_ticks", static_cast<std::uint64_t>(timing.late_ticks));
  hdf5::write_numbers(file, "servo_worst_late_s", std::span(&timing.worst_late_s, 1));
  hdf5::write_numbers(file, "servo_worst_tick_s", std::span(&timing.worst_tick_s, 1));
  hdf5::write_numbers(file, "servo_histogram_upper_s", upper_s);
  hdf5::write_numbers(file, "servo_tick_time_counts", tick_times);
  hdf5::write_numbers(file, "servo_lateness_counts", latenesses);
}

hdf5::NumberType type_of(ColumnKind kind) {
  if (kind == ColumnKind::phase) return hdf5::NumberType::uint8;
  return kind == ColumnKind::index ? hdf5::NumberType::int32 : hdf5::NumberType::float64;
}

class Hdf5TraceWriter final : public TraceWriter {
 public:
  Hdf5TraceWriter(const std::string& path, const TraceInfo& info, const World& world)
      : columns_(trace_columns(info)) {
    const hdf5::Turn turn;
    file_ = hdf5::create_file(path);
    write_info(file_, info);
    write_surfaces(file_, world, info.scene_text);
    for (const TraceColumn& column : columns_) {
      datasets_.push_back(hdf5::create_column(file_, std::string(column.name), type_of(column.kind),
                                              std::string(column.unit)));
      if (!column.values.empty()) hdf5::write_text(datasets_.back(), "values", std::string(column.values));
    }
    change_log_.add(file_, info.changes);
    hdf5::flush(file_);
    pending_.reserve(flushed_rows);
  }

  void append(std::span<const TickRecord> rows) override {
    for (const TickRecord& row : rows) {
      pending_.push_back(row);
      if (pending_.size() == flushed_rows) flush();
    }
  }

  void flush() override {
    if (pending_.empty()) return;
    const hdf5::Turn turn;
    write_pending();
    hdf5::flush(file_);
  }

  void note_changes(std::span<const SceneChange> changes) override {
    const hdf5::Turn turn;
    change_log_.add(file_, changes);
  }

  void note_timing(const ServoTiming& timing) override {
    const hdf5::Turn turn;
    write_timing(file_, timing);
  }

  void finish() override {
    const std::string path = file_.path();
    {
      const hdf5::Turn turn;
      write_pending();
      hdf5::flush(file_);  // the rows are safe before the file calls itself complete
      hdf5::write_flag(file_, "complete", true);
      hdf5::flush(file_);
      datasets_.clear();
      change_log_.close();
      hdf5::close_file(std::move(file_));
    }
    seal_file(path);
  }

 private:
  void write_pending() {
    if (pending_.empty()) return;
    std::vector<double> values(pending_.size());
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      for (std::size_t i = 0; i < pending_.size(); ++i) values[i] = columns_[k].get(pending_[i]);
      hdf5::append(datasets_[k], rows_, values);
    }
    rows_ += pending_.size();
    pending_.clear();
  }

  hdf5::Handle file_;
  std::vector<TraceColumn> columns_;
  std::vector<hdf5::Handle> datasets_;  // one a column
  std::vector<TickRecord> pending_;
  std::size_t rows_ = 0;  // in the file
  Hdf5ChangeLog change_log_;
};

class CsvTraceWriter final : public TraceWriter {
 public:
  CsvTraceWriter(const std::string& path, const TraceInfo& info)
      : columns_(csv_columns(info)), file_(path, OutputFile::Unfinished::kept), change_file_(path) {
    file_.write(csv_header(columns_));
    change_file_.add(info.changes);
    file_.flush();  // from here on it can be read, whatever becomes of the program
  }

  void append(std::span<const TickRecord> rows) override {
    for (const TickRecord& row : rows) {
      append_csv_row(text_, columns_, row);
      if (text_.size() > std::size_t{1} << 20) write_text();
    }
  }

  void note_changes(std::span<const SceneChange> changes) override { change_file_.add(changes); }

  void flush() override {
    change_file_.flush();  // before the rows that were felt under them
    write_text();
    file_.flush();
  }

  void finish() override {
    write_text();
    change_file_.commit();
    file_.commit();
  }

 private:
  void write_text() {
    file_.write(text_);
    text_.clear();
  }

  std::vector<TraceColumn> columns_;
  OutputFile file_;
  ChangeFile change_file_;
  std::string text_;
};

}  // namespace

std::unique_ptr<TraceWriter> TraceWriter::create(const std::string& path, TraceFormat format,
                                                 const TraceInfo& info, const World& world) {
  if (format == TraceFormat::csv) return std::make_unique<CsvTraceWriter>(path, info);
  return std::make_unique<Hdf5TraceWriter>(path, info, world);
}

}  // namespace fingerpad
