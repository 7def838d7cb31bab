#include "trace/trace_writer.hpp"

#include <vector>

#include "base/checksum.hpp"
#include "trace/change_log.hpp"
#include "trace/csv_rows.hpp"
#include "trace/hdf5_trace_writer.hpp"
#include "trace/output_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

class CsvTraceWriter final : public TraceWriter {
 public:
  CsvTraceWriter(const std::string& path, const TraceInfo& info)
      : columns_(csv_columns(info)),
        every_(info.every),
        file_(path, OutputFile::Unfinished::kept),
        change_file_(path) {
    text_ = csv_header(columns_, every_);
    write_text();
    change_file_.add(info.changes);
    file_.flush();  // from here on it can be read, whatever becomes of the program
  }

  void append(std::span<const TickRecord> rows) override {
    for (const TickRecord& row : rows) {
      append_csv_row(text_, columns_, row, every_);
      if (text_.size() > std::size_t{1} << 20) write_text();
    }
  }

  void note_changes(std::span<const SceneChange> changes) override { change_file_.add(changes); }

  void flush() override {
    change_file_.flush();  // before the rows that were felt under them
    write_text();
    file_.flush();
  }

  FileSum finish() override {
    write_text();
    change_file_.commit();
    file_.commit();
    return {size_, sum_.value(size_)};
  }

 private:
  void write_text() {
    file_.write(text_);
    sum_.add(text_.data(), text_.size());
    size_ += text_.size();
    text_.clear();
  }

  std::vector<TraceColumn> columns_;
  std::uint64_t every_;
  OutputFile file_;
  ChangeFile change_file_;
  std::string text_;
  Checksum sum_;
  std::uint64_t size_ = 0;
};

}  // namespace

std::unique_ptr<TraceWriter> TraceWriter::create(const std::string& path, TraceFormat format,
                                                 const TraceInfo& info, const World& world,
                                                 std::uint64_t rows_to_come) {
  if (format == TraceFormat::csv) return std::make_unique<CsvTraceWriter>(path, info);
  return create_hdf5_writer(path, info, world, rows_to_come);
}

}  // namespace fingerpad
