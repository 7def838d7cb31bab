#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "view/abscissa.hpp"
#include "view/touch_series.hpp"

namespace fingerpad {

/// A quantity as another trace tells it that has some of the ticks.
struct ThinnedColumn {
  std::vector<double> by_t_s;      ///< the other's
  std::vector<std::size_t> ticks;  ///< indices among all of those that it has
  std::vector<double> values;      ///< one each; nan where there is none
};

/// One quantity of a run against what it is compared over.
struct ComparedColumn {
  std::string name;            ///< as the trace calls it, or "friction" along the sliding direction
  std::string unit;            ///< "N", "m"
  std::vector<double> values;  ///< one a tick; nan where there is none
  /// By each such trace; empty where that tells it alike. Friction along the sliding direction goes by the
  /// way from one row to the next.
  std::vector<ThinnedColumn> thinned = {};
};

/// A trace, or a table of measurements, as far as it can be laid over another.
struct ComparedRun {
  std::string name;          ///< what tells it from the others, for the legend
  std::string scene, title;  ///< of a trace: its scene's name, and with its meshes; else the file's
  std::string path;
  std::string scene_text;  ///< empty where it holds none
  bool is_trace = false;
  std::vector<double> x;  ///< never goes back
  std::vector<ComparedColumn> columns;
  std::vector<double> t_s = {};  ///< of a trace: when each tick was
  bool x_by_fewer = false;       ///< its way is told as a trace of fewer ticks tells it
  bool lacks_ticks = false;      ///< of its ticks some were left out, as far as its trace tells
  bool several_walls = false;    ///< hold the finger at some tick
  std::uint64_t every = 1;       ///< its rows are every so manieth tick, as its trace says
  std::string ends_early = {};   ///< early_end_words() of its trace
  double lasts_s = 0;            ///< the whole file, what is left out too
  std::size_t file_rows = 0;     ///< likewise
  RubLine rub = {};              ///< of a trace
};

/// Reads a trace, or a table with a column t_s and others named as a trace's (fx_n, fn_n, x_m). Over
/// something else than time only a trace can be drawn: it knows the surface. Throws Error (refused) for a
/// file that is neither, and as read_trace and read_csv_columns.
/// @param from_s, to_s  what is earlier or later is left out
ComparedRun read_compared_run(const std::string& path, Over over, double from_s, double to_s);
/// Several. Where one is a trace of some of another's ticks, the other's way and its friction along the
/// sliding direction are told by these ticks too: from one to the next it is shorter than between them.
std::vector<ComparedRun> read_compared_runs(const std::vector<std::string>& paths, Over over, double from_s,
                                            double to_s);

/// Whether a file of text names a time t_s and is no trace. False for a stream, and for what cannot be read.
bool is_measured_table(const std::string& path);

/// Gives each the name that tells it from the others: what its scene differs in, or else its file. Where all
/// have one, they keep it.
void name_apart(std::vector<ComparedRun>& runs);

}  // namespace fingerpad
