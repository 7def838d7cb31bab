#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/chart.hpp"

namespace fingerpad::bench {

/// A block that lies on a plane, z up, and is pushed along x: the same one in every program.
struct BlockSetup {
  double rate_hz = 1000;
  double mass_kg = 1;
  double gravity_m_per_s2 = 9.81;
  double mu_static = 0.3;      ///< the only coefficient where a program has one
  double mu_dynamic = 0.2;     ///< where a program has two
  double v_min_m_per_s = 0.1;  ///< of a law that reads it, as all below; these are the program's defaults
  double zero_band_m_per_s = 0.001;
  double stick_stiffness_per_m = 1000;

  double limit_n() const { return mu_static * mass_kg * gravity_m_per_s2; }
};

/// The block in one of the programs.
class Block {
 public:
  virtual ~Block() = default;
  /// One step of the program, with a push along x that is held over it.
  virtual void step(double push_n) = 0;
  virtual double x_m() const = 0;
  virtual double speed_m_per_s() const = 0;
};

/// A program with its settings: a row of the table.
struct Program {
  std::string name;
  CurveStyle style;
  std::function<std::unique_ptr<Block>(const BlockSetup&)> make;
};

std::vector<Program> fingerpad_programs();
std::vector<Program> mujoco_programs();
std::vector<Program> bullet_programs();

}  // namespace fingerpad::bench
