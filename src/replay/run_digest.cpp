#include "replay/run_digest.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "base/build_identity.hpp"
#include "base/content_hash.hpp"
#include "base/number_text.hpp"
#include "scene/scene_change.hpp"

namespace fingerpad {
namespace {

std::string hash_text(std::string_view text) {
  return fmt::format("{:016x}", content_hash(std::as_bytes(std::span(text))));
}

/// Gathers what decides a run, kind by kind.
class RunText {
 public:
  void begin(std::string_view kind) {
    end_kind();
    digest_.kinds.push_back({kind, ""});
  }
  void add(std::string_view field) { kind_ += fmt::format("{}:{};", field.size(), field); }
  void add_all(const std::vector<std::string>& fields) {
    add(std::to_string(fields.size()));
    for (const std::string& field : fields) add(field);
  }
  RunDigest digest() {
    end_kind();
    digest_.whole = hash_text(all_);
    return std::move(digest_);
  }

 private:
  void end_kind() {
    if (!digest_.kinds.empty()) digest_.kinds.back().hash = hash_text(kind_);
    all_ += fmt::format("{}:{};", kind_.size(), kind_);
    kind_.clear();
  }

  std::string kind_, all_;
  RunDigest digest_;
};

/// A kind of things that decide a run's bytes, how it is told that they are others than when a trace was
/// made, and what they are.
struct RunKind {
  std::string_view name, changed;
  void (*add)(RunText& run, const TraceInfo& info, TraceFormat format);
};

constexpr RunKind run_kinds[] = {
    {"output", "the format, --columns, --every or --compress is another now",
     [](RunText& run, const TraceInfo& info, TraceFormat format) {
       run.add(format == TraceFormat::csv ? "csv" : "h5");
       if (!info.columns.empty()) run.add_all(info.columns);
       if (info.every != 1) run.add(fmt::format("every {}", info.every));
       if (info.deflated) run.add("deflated");
     }},
    {"program", "the program has changed since",
     [](RunText& run, const TraceInfo& info, TraceFormat) {
       run.add(build_identity());
       run.add(info.version);
     }},
    {"scene", "the scene has changed since",
     [](RunText& run, const TraceInfo& info, TraceFormat) {
       for (const std::string* field : {&info.scene_name, &info.scene_text, &info.motion_file})
         run.add(*field);
       run.add(std::to_string(info.seed));
       run.add_all(info.mesh_files);
     }},
    {"meshes", "a mesh file has changed since",
     [](RunText& run, const TraceInfo& info, TraceFormat) { run.add_all(info.mesh_hashes); }},
    {"motion", "the motion has changed since",
     [](RunText& run, const TraceInfo& info, TraceFormat) {
       run.add(info.motion_hash);
       run.add_all(info.motion_notes);
       run.add(number_text(info.rate_hz));
       if (!info.changes.empty()) run.add(scene_changes_text(info.changes));
     }},
    {"profile", "the profile has changed since",
     [](RunText& run, const TraceInfo& info, TraceFormat) { run.add(info.profile_text); }},
    {"contact", "the part is touched by another contact method or other normals now",
     [](RunText& run, const TraceInfo& info, TraceFormat) {
       run.add(info.contact_method);
       run.add(info.contact_normals);
       run.add_all(info.contact_reasons);
     }},
};

}  // namespace

RunDigest run_digest(const TraceInfo& info, TraceFormat format) {
  RunText run;
  for (const RunKind& kind : run_kinds) {
    run.begin(kind.name);
    kind.add(run, info, format);
  }
  return run.digest();
}

std::string changed_words(std::string_view kind) {
  for (const RunKind& row : run_kinds) {
    if (row.name == kind) return std::string(row.changed);
  }
  return "it is of another run";
}

}  // namespace fingerpad
