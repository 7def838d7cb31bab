#include "trace/hdf5_trace_writer.hpp"

#include <utility>
#include <vector>

#include "touch/world.hpp"
#include "trace/change_log.hpp"
#include "trace/column_chunks.hpp"
#include "trace/embedded_surfaces.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

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
  if (info.deflated) hdf5::write_flag(file, "deflated", true);
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
  Hdf5TraceWriter(const std::string& path, const TraceInfo& info, const World& world,
                  std::uint64_t rows_to_come)
      : chunks_(trace_columns(info), chunk_rows_for(rows_to_come)), deflated_(info.deflated) {
    // A recording is to be read up to where it was killed; of a replay's job that was, another is made.
    const bool is_recording = rows_to_come == 0 && !deflated_;
    file_ = hdf5::create_file(path, is_recording ? hdf5::Layout::paged : hdf5::Layout::tight);
    write_info(file_, info);
    write_surfaces(file_, world, info.scene_text, deflated_ ? hdf5::Packing::deflated : hdf5::Packing::plain);
    const hdf5::Turn turn;
    for (const TraceColumn& column : chunks_.columns()) {
      const hdf5::ColumnLayout layout{type_of(column.kind), chunks_.chunk_rows(), is_deflated(column)};
      datasets_.push_back(
          hdf5::create_column(file_, std::string(column.name), layout, std::string(column.unit)));
      if (!column.values.empty()) hdf5::write_text(datasets_.back(), "values", std::string(column.values));
    }
    change_log_.add(file_, info.changes);
    hdf5::flush(file_);
  }

  void append(std::span<const TickRecord> rows) override {
    while (!rows.empty()) {
      rows = rows.subspan(chunks_.add(rows));
      if (chunks_.is_full()) flush();
    }
  }

  void flush() override {
    if (chunks_.row_count() == 0) return;
    write_chunks();
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

  FileSum finish() override {
    const std::string path = file_.path();
    write_chunks();
    {
      const hdf5::Turn turn;
      hdf5::flush(file_);  // the rows are safe before the file calls itself complete
      hdf5::write_flag(file_, "complete", true);
      hdf5::flush(file_);
      datasets_.clear();
      change_log_.close();
      hdf5::close_file(std::move(file_));
    }
    return seal_file(path);
  }

 private:
  /// Time stays plain, so that a row takes eight bytes at least and what a file unfolds to has a bound.
  bool is_deflated(const TraceColumn& column) const noexcept { return deflated_ && column.name != "t_s"; }

  /// Writes the chunk under way; it is written again where it was not full.
  void write_chunks() {
    if (chunks_.row_count() == 0) return;
    chunks_.clear_rest();
    const std::uint64_t rows = first_row_ + chunks_.row_count();
    std::vector<hdf5::ColumnChunk> written;
    for (std::size_t k = 0; k < datasets_.size(); ++k) {
      const std::span<const std::byte> chunk = chunks_.chunk(k);
      const TraceColumn& column = chunks_.columns()[k];
      written.push_back({&datasets_[k], is_deflated(column)
                                            ? hdf5::packed_chunk(chunk, kept_bytes(column.kind), room_)
                                            : hdf5::ChunkBytes{chunk}});
      if (!deflated_ && k + 1 < datasets_.size()) continue;
      hdf5::write_chunks(written, first_row_, rows);  // one by one where they share the room for packing
      written.clear();
    }
    if (!chunks_.is_full()) return;
    first_row_ = rows;
    chunks_.begin();
  }

  hdf5::Handle file_;
  ColumnChunks chunks_;
  bool deflated_;
  std::vector<hdf5::Handle> datasets_;  // one a column
  std::uint64_t first_row_ = 0;         // of the chunk under way
  std::vector<std::byte> room_;
  Hdf5ChangeLog change_log_;
};

}  // namespace

std::unique_ptr<TraceWriter> create_hdf5_writer(const std::string& path, const TraceInfo& info,
                                                const World& world, std::uint64_t rows_to_come) {
  return std::make_unique<Hdf5TraceWriter>(path, info, world, rows_to_come);
}

}  // namespace fingerpad
