// The block in MuJoCo: a free box of 0.1 m on a plane.

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <stdexcept>

#include "creep_block.hpp"

namespace fingerpad::bench {
namespace {

struct Freed {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

using Model = std::unique_ptr<mjModel, Freed>;

/// @param option  attributes of MuJoCo's <option>; empty: all its defaults
Model model_of(const BlockSetup& setup, const std::string& option) {
  const std::string friction = fmt::format("friction='{} 0.005 0.0001'", setup.mu_static);
  const std::string scene = fmt::format(
      "<mujoco><option timestep='{}' gravity='0 0 -{}' {}/><worldbody>"
      "<geom type='plane' size='10 10 0.1' {}/>"
      "<body pos='0 0 0.05'><freejoint/><geom type='box' size='0.05 0.05 0.05' mass='{}' {}/></body>"
      "</worldbody></mujoco>",
      1 / setup.rate_hz, setup.gravity_m_per_s2, option, friction, setup.mass_kg, friction);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "block.xml", static_cast<int>(scene.size()));
  std::memcpy(files->filedata[0], scene.data(), scene.size());
  char why[1000] = "";
  Model model(mj_loadXML("block.xml", files.get(), why, sizeof why));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(fmt::format("MuJoCo refuses the block: {}", why));
  return model;
}

class MujocoBlock : public Block {
 public:
  MujocoBlock(const BlockSetup& setup, const std::string& option)
      : model_(model_of(setup, option)), data_(mj_makeData(model_.get())) {}

  void step(double push_n) override {
    data_->qfrc_applied[0] = push_n;
    mj_step(model_.get(), data_.get());
  }

  double x_m() const override { return data_->qpos[0]; }
  double speed_m_per_s() const override { return data_->qvel[0]; }

 private:
  Model model_;
  std::unique_ptr<mjData, Freed> data_;
};

Program program(const std::string& name, const std::string& option, const CurveStyle& style) {
  return {"MuJoCo" + name, style,
          [=](const BlockSetup& setup) { return std::make_unique<MujocoBlock>(setup, option); }};
}

}  // namespace

std::vector<Program> mujoco_programs() {
  return {
      program("", "", {palette::vermillion, Dash::solid, Marker::square}),
      program(", elliptic cone", "cone='elliptic'", {palette::orange, Dash::dashed, Marker::disc}),
      program(", elliptic, impratio 10, noslip 20", "cone='elliptic' impratio='10' noslip_iterations='20'",
              {palette::reddish_purple, Dash::dash_dot, Marker::diamond})};
}

}  // namespace fingerpad::bench
