#include "part/verdict_words.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

/// "1 edge", "2 edges".
std::string many(long count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void tell_repair(const RepairCounts& repair, Verdict& verdict) {
  std::vector<std::string> done;
  const auto tell = [&](long count, std::string_view one, std::string_view what) {
    if (count > 0) done.push_back("repaired: " + many(count, one) + std::string(what));
  };
  if (repair.welded_vertices > 0) {
    done.push_back(
        fmt::format("repaired: vertices up to {} m apart were taken as one ({} fewer); no "
                    "coordinate was changed",
                    rounded_text(verdict.weld_distance_m, 2), repair.welded_vertices));
  }
  tell(repair.turned_triangles, "triangle", " turned round, to be wound as the rest of the piece");
  tell(repair.turned_bodies, "closed shell", " turned outwards");
  tell(repair.turned_cavities, "closed shell", " inside a body turned inwards, as a cavity");
  if (repair.nesting_unknown) {
    done.emplace_back("repaired: so many closed shells overlap that none was taken as a cavity");
  }
  verdict.warnings.insert(verdict.warnings.end(), done.begin(), done.end());
}

void tell_faces(const RawMesh& mesh, const Fan& fan, Verdict& verdict) {
  auto& warnings = verdict.warnings;
  if (mesh.short_polygons > 0) {
    warnings.push_back(many(mesh.short_polygons, "face") + " with fewer than three corners left out");
  }
  if (fan.out_of_range > 0) {
    warnings.push_back(
        fmt::format("{} left out: an index is out of range, it names a vertex that is not among the {} "
                    "(first in face {})",
                    many(fan.out_of_range, "triangle"), mesh.vertices.size(), fan.first_out_of_range));
  }
  if (fan.concave > 0) {
    warnings.push_back(
        fmt::format("{} concave: fanned from the first corner, some of their triangles fold over",
                    many(fan.concave, "polygon") + (fan.concave == 1 ? " is" : " are")));
  }
  if (verdict.degenerate > 0) {
    warnings.push_back(many(verdict.degenerate, "degenerate triangle") +
                       (verdict.repaired ? " (without area): left out, but for those that join others"
                                         : " (without area): nothing to touch there"));
  }
  if (verdict.duplicate > 0) {
    warnings.push_back(
        fmt::format("{} (the same three corners again, in either winding): the first of each is kept",
                    many(verdict.duplicate, "duplicate triangle")));
  }
}

void tell_edges(Verdict& verdict) {
  auto& warnings = verdict.warnings;
  if (verdict.boundary_edges > 0) {
    std::string text = "open: " + many(verdict.boundary_edges, "boundary edge");
    const long counted = verdict.triangles - verdict.out_of_range;
    if (counted > 1 && verdict.boundary_edges == 3 * counted) {
      text += " (no two triangles share an edge: a soup, or cracks wider than 1e-7 of the diagonal)";
    }
    warnings.push_back(text + "; a finger can pass through, and its side is told by the closest facet alone");
  }
  if (verdict.nonmanifold_edges > 0) {
    warnings.push_back(fmt::format(
        "non-manifold: {} with more than two triangles; inside and outside may be wrong near them",
        many(verdict.nonmanifold_edges, "edge")));
  }
  if (verdict.inconsistent_edges > 0) {
    warnings.push_back(
        fmt::format("inconsistent winding: at {} the triangles on both sides are wound against each other; "
                    "inside and outside may be wrong near them{}",
                    many(verdict.inconsistent_edges, "edge"),
                    verdict.repaired ? "" : "; repair = true in a scene (check --repair) turns them alike"));
  }
}

void tell_numbers(const BuiltPart& built, bool float32, Verdict& verdict) {
  auto& warnings = verdict.warnings;
  const double size = built.part.size_m();
  if (built.census.inside_out) {
    warnings.emplace_back("wound inwards (negative volume): inside and outside are swapped");
  } else if (built.census.inward_bodies > 0) {
    warnings.push_back(fmt::format("{} wound inwards: inside and outside are swapped there",
                                   built.census.inward_bodies == 1
                                       ? std::string("one closed body is")
                                       : fmt::format("{} closed bodies are", built.census.inward_bodies)));
  }
  if (built.census.outward_cavities > 0 && !built.census.inside_out) {
    const bool one = built.census.outward_cavities == 1;
    warnings.push_back(
        fmt::format("{} inside another and {} wound outwards too: touched as overlapping solids, "
                    "not as cavities",
                    one ? std::string("one closed body lies")
                        : fmt::format("{} closed bodies lie", built.census.outward_cavities),
                    one ? "is" : "are"));
  }
  if (verdict.weld_distance_m > 0 && !verdict.repaired) {
    warnings.push_back(
        fmt::format("cracked: vertices up to {} m apart were taken as one, which closes the mesh; no "
                    "coordinate was changed",
                    rounded_text(verdict.weld_distance_m, 2)));
  }
  constexpr double noticeable = 1e-6;  // of the part's size
  if (verdict.rounding_m > noticeable * size) {
    warnings.push_back(
        fmt::format("rounding the file's numbers to float32 moves vertices by up to {} m ({} of the "
                    "part's size): move the part to the origin and export again",
                    rounded_text(verdict.rounding_m, 2), rounded_text(verdict.rounding_m / size, 1)));
  } else if (float32 && verdict.resolution_m > noticeable * size) {
    warnings.push_back(
        fmt::format("lies so far from the origin that its float32 coordinates step by {} m ({} of the "
                    "part's size): move it to the origin and export again",
                    rounded_text(verdict.resolution_m, 2), rounded_text(verdict.resolution_m / size, 1)));
  }
}

std::string_view yes_no(bool value) {
  return value ? "yes" : "no";
}

}  // namespace

void add_warnings(const RawMesh& mesh, const Fan& fan, const BuiltPart& built, Verdict& verdict) {
  if (verdict.repaired) tell_repair(built.census.repair, verdict);
  tell_faces(mesh, fan, verdict);
  tell_edges(verdict);
  tell_numbers(built, mesh.float32, verdict);
}

std::string refusal_text(const Verdict& verdict) {
  return verdict.file + ": " + verdict.error;
}

std::string verdict_text(const Verdict& verdict) {
  std::string text = fmt::format("{}: {}\n", printable(verdict.file),
                                 !verdict.touchable         ? "refused"
                                 : verdict.warnings.empty() ? "can be touched"
                                                            : "can be touched, with care");
  if (!verdict.error.empty()) text += fmt::format("  refused        {}\n", printable(verdict.error));
  for (const std::string& warning : verdict.warnings)
    text += fmt::format("  warning        {}\n", printable(warning));
  if (!verdict.format.empty()) {
    text += fmt::format("  {:<14} {}, {}, {} kept\n", verdict.format,
                        verdict.vertices == 1 ? "1 vertex" : many(verdict.vertices, "vertice"),
                        many(verdict.triangles, "triangle"), verdict.kept);
  }
  if (verdict.kept == 0) return text;
  const Vec3 size_mm = 1e3 * (verdict.bounds_m.max - verdict.bounds_m.min);
  const Vec3 from_mm = 1e3 * verdict.bounds_m.min;
  text +=
      fmt::format("  size           {} x {} x {} mm, from ({}, {}, {}) mm\n", rounded_text(size_mm.x(), 6),
                  rounded_text(size_mm.y(), 6), rounded_text(size_mm.z(), 6), rounded_text(from_mm.x(), 6),
                  rounded_text(from_mm.y(), 6), rounded_text(from_mm.z(), 6));
  text += fmt::format("  closed         {}; {} boundary, {} non-manifold, {} inconsistent edges\n",
                      yes_no(verdict.closed), verdict.boundary_edges, verdict.nonmanifold_edges,
                      verdict.inconsistent_edges);
  text += fmt::format("  components     {}\n", verdict.components);
  text += fmt::format("  volume         {} cm3{}\n", rounded_text(1e6 * verdict.volume_m3, 6),
                      verdict.closed ? "" : " (not closed: of no meaning)");
  return text;
}

}  // namespace fingerpad
