#include <cstdint>
#include <cstring>
#include <type_traits>

#include "trace/trace_choice.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

/// How HDF5 keeps a value of the record: a double, a phase in a byte, all else in 32 bits.
template <typename Value>
using Kept = std::conditional_t<std::is_floating_point_v<Value>, double,
                                std::conditional_t<std::is_same_v<Value, Phase>, std::uint8_t, std::int32_t>>;

/// @param value  of a record
template <typename Of>
void gather_rows(std::span<const TickRecord> rows, std::byte* out, Of value) noexcept {
  using K = Kept<std::remove_cvref_t<decltype(value(rows.front()))>>;
  for (const TickRecord& record : rows) {
    const K kept = static_cast<K>(value(record));
    std::memcpy(out, &kept, sizeof(kept));
    out += sizeof(kept);
  }
}

/// A number of the record.
template <auto member>
constexpr TraceColumn column(std::string_view name, std::string_view unit, std::string_view doc,
                             ColumnKind kind = ColumnKind::number, std::string_view values = {}) {
  return {name,
          unit,
          doc,
          kind,
          [](const TickRecord& record) noexcept { return static_cast<double>(record.*member); },
          [](TickRecord& record, double value) noexcept {
            record.*member = static_cast<std::remove_reference_t<decltype(record.*member)>>(value);
          },
          [](std::span<const TickRecord> rows, std::byte* out) noexcept {
            gather_rows(rows, out, [](const TickRecord& record) { return record.*member; });
          },
          values};
}

/// A component of one of its vectors.
template <auto member, int axis>
constexpr TraceColumn column(std::string_view name, std::string_view unit, std::string_view doc,
                             ColumnKind kind = ColumnKind::number) {
  return {name,
          unit,
          doc,
          kind,
          [](const TickRecord& record) noexcept { return (record.*member)[axis]; },
          [](TickRecord& record, double value) noexcept { (record.*member)[axis] = value; },
          [](std::span<const TickRecord> rows, std::byte* out) noexcept {
            gather_rows(rows, out, [](const TickRecord& record) { return (record.*member)[axis]; });
          }};
}

constexpr TraceColumn only(ColumnOf of, TraceColumn column) {
  column.of = of;
  return column;
}

constexpr TraceColumn of_the_way(TraceColumn column) {
  column.of_the_way = true;
  return column;
}

constexpr std::string_view
    finger = "the finger",
    touched = "contact point and outward normal; nan while free", whole = "whole force on the finger",
    part_of_it = "its friction part", centre = "stick centre; nan unless sticking",
    what =
        "what is touched most: parts, then planes, from 0; the triangle in file order; -1 "
        "while free";
constexpr std::string_view
    encoded = "of a `[hand]`: the finger as its encoders told it",
    pushed = "of a `[hand]`: what it pushed the finger with",
    seen = "where it is estimated from an encoder's readings: the finger's velocity",
    pointed = "of a finger that turns: its direction, towards the tip",
    turned = "of a finger that turns: its attitude, finger to world",
    sent = "of a device with motors: what its limits left of the force, in the world's axes",
    beyond = "of a motion with a measured force: the model's whole force less the measured one";

/// What says whether a trace has such columns; nullptr where nothing needs to.
bool TraceInfo::*flag_of(ColumnOf of) noexcept {
  switch (of) {
    case ColumnOf::hands:
      return &TraceInfo::in_hand;
    case ColumnOf::estimated:
      return &TraceInfo::estimated;
    case ColumnOf::turning:
      return &TraceInfo::turning;
    case ColumnOf::attitudes:
      return &TraceInfo::attitudes;
    case ColumnOf::sent:
      return &TraceInfo::sent;
    case ColumnOf::compared:
      return &TraceInfo::compared;
    case ColumnOf::several_walls:
      return &TraceInfo::several_walls;
    case ColumnOf::every_trace:
    case ColumnOf::hdf5:
      break;
  }
  return nullptr;
}

using R = TickRecord;
using Kind = ColumnKind;

}  // namespace

std::span<const TraceColumn> trace_columns() noexcept {
  static constexpr TraceColumn table[] = {
      column<&R::t_s>("t_s", "s", "time", Kind::place),
      of_the_way(column<&R::p_WQ, 0>("x_m", "m", finger, Kind::place)),
      of_the_way(column<&R::p_WQ, 1>("y_m", "m", finger, Kind::place)),
      of_the_way(column<&R::p_WQ, 2>("z_m", "m", finger, Kind::place)),
      column<&R::phase>("phase", "1", "`free`, `stick`, `slip` (0, 1, 2 in HDF5)", Kind::phase,
                        "0 free, 1 stick, 2 slip"),
      column<&R::depth_m>("depth_m", "m", "radius less signed distance, where positive"),
      column<&R::contact_W, 0>("px_m", "m", touched),
      column<&R::contact_W, 1>("py_m", "m", touched),
      column<&R::contact_W, 2>("pz_m", "m", touched),
      column<&R::normal_W, 0>("nx", "1", touched),
      column<&R::normal_W, 1>("ny", "1", touched),
      column<&R::normal_W, 2>("nz", "1", touched),
      column<&R::normal_force_n>("fn_n", "N", "normal force"),
      column<&R::force_W_n, 0>("fx_n", "N", whole),
      column<&R::force_W_n, 1>("fy_n", "N", whole),
      column<&R::force_W_n, 2>("fz_n", "N", whole),
      column<&R::friction_W_n, 0>("ffx_n", "N", part_of_it),
      column<&R::friction_W_n, 1>("ffy_n", "N", part_of_it),
      column<&R::friction_W_n, 2>("ffz_n", "N", part_of_it),
      column<&R::mu>("mu", "1", "friction over normal force, 0 while free"),
      column<&R::stick_centre_W, 0>("cx_m", "m", centre),
      column<&R::stick_centre_W, 1>("cy_m", "m", centre),
      column<&R::stick_centre_W, 2>("cz_m", "m", centre),
      column<&R::inclination_rad>("angle_rad", "rad", "the finger's inclination to the surface"),
      column<&R::surface>("part", "1", what, Kind::index),
      column<&R::triangle>("triangle", "1", what, Kind::index),
      only(ColumnOf::several_walls,
           column<&R::walls>("walls", "1",
                             "where several walls can hold the finger: how many do; the forces are their sum",
                             Kind::index)),
      only(ColumnOf::hdf5,
           column<&R::ruptures>("ruptures", "1", "in HDF5 alone: how often stick gave way within the tick",
                                Kind::index)),
      only(ColumnOf::hands, of_the_way(column<&R::encoded_W, 0>("ex_m", "m", encoded))),
      only(ColumnOf::hands, of_the_way(column<&R::encoded_W, 1>("ey_m", "m", encoded))),
      only(ColumnOf::hands, of_the_way(column<&R::encoded_W, 2>("ez_m", "m", encoded))),
      only(ColumnOf::hands, column<&R::push_W_n, 0>("hx_n", "N", pushed)),
      only(ColumnOf::hands, column<&R::push_W_n, 1>("hy_n", "N", pushed)),
      only(ColumnOf::hands, column<&R::push_W_n, 2>("hz_n", "N", pushed)),
      only(ColumnOf::estimated, column<&R::velocity_W, 0>("vx_m_per_s", "m/s", seen)),
      only(ColumnOf::estimated, column<&R::velocity_W, 1>("vy_m_per_s", "m/s", seen)),
      only(ColumnOf::estimated, column<&R::velocity_W, 2>("vz_m_per_s", "m/s", seen)),
      only(ColumnOf::turning, of_the_way(column<&R::direction_W, 0>("dx", "1", pointed))),
      only(ColumnOf::turning, of_the_way(column<&R::direction_W, 1>("dy", "1", pointed))),
      only(ColumnOf::turning, of_the_way(column<&R::direction_W, 2>("dz", "1", pointed))),
      only(ColumnOf::attitudes, of_the_way(column<&R::attitude, 0>("qw", "1", turned))),
      only(ColumnOf::attitudes, of_the_way(column<&R::attitude, 1>("qx", "1", turned))),
      only(ColumnOf::attitudes, of_the_way(column<&R::attitude, 2>("qy", "1", turned))),
      only(ColumnOf::attitudes, of_the_way(column<&R::attitude, 3>("qz", "1", turned))),
      only(ColumnOf::sent, column<&R::sent_W_n, 0>("sx_n", "N", sent)),
      only(ColumnOf::sent, column<&R::sent_W_n, 1>("sy_n", "N", sent)),
      only(ColumnOf::sent, column<&R::sent_W_n, 2>("sz_n", "N", sent)),
      only(ColumnOf::compared, column<&R::residual_W_n, 0>("rfx_n", "N", beyond)),
      only(ColumnOf::compared, column<&R::residual_W_n, 1>("rfy_n", "N", beyond)),
      only(ColumnOf::compared, column<&R::residual_W_n, 2>("rfz_n", "N", beyond)),
  };
  return table;
}

std::vector<TraceColumn> trace_columns(const TraceInfo& info) {
  std::vector<TraceColumn> columns;
  for (const TraceColumn& column : trace_columns()) {
    const auto flag = flag_of(column.of);
    if (flag == nullptr || info.*flag) columns.push_back(column);
  }
  return chosen(std::move(columns), info);
}

std::vector<TraceColumn> csv_columns(const TraceInfo& info) {
  std::vector<TraceColumn> columns = trace_columns(info);
  std::erase_if(columns, [](const TraceColumn& column) { return column.of == ColumnOf::hdf5; });
  return columns;
}

void tell_of(const TraceColumn& column, TraceInfo& info) noexcept {
  if (const auto flag = flag_of(column.of); flag != nullptr) info.*flag = true;
}

}  // namespace fingerpad
