// The block in Bullet (single precision, as its packages are used): a free box of 0.1 m on a plane.

#include <btBulletDynamicsCommon.h>

#include "creep_block.hpp"

namespace fingerpad::bench {
namespace {

class BulletBlock : public Block {
 public:
  BulletBlock(const BlockSetup& setup, bool may_sleep)
      : dt_s_(static_cast<btScalar>(1 / setup.rate_hz)),
        box_(box_of(setup, shape_)),
        ground_(0, nullptr, &plane_) {
    world_.setGravity(btVector3(0, 0, -static_cast<btScalar>(setup.gravity_m_per_s2)));
    ground_.setFriction(1);  // Bullet multiplies the two
    box_.setFriction(static_cast<btScalar>(setup.mu_static));
    if (!may_sleep) box_.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&ground_);
    world_.addRigidBody(&box_);
  }
  ~BulletBlock() override {
    world_.removeRigidBody(&box_);
    world_.removeRigidBody(&ground_);
  }
  BulletBlock(const BulletBlock&) = delete;
  BulletBlock& operator=(const BulletBlock&) = delete;

  void step(double push_n) override {
    box_.applyCentralForce(btVector3(static_cast<btScalar>(push_n), 0, 0));
    world_.stepSimulation(dt_s_, 0);
  }

  double x_m() const override { return static_cast<double>(box_.getCenterOfMassPosition().x()); }
  double speed_m_per_s() const override { return static_cast<double>(box_.getLinearVelocity().x()); }

 private:
  static btRigidBody::btRigidBodyConstructionInfo box_of(const BlockSetup& setup, btBoxShape& shape) {
    const auto mass_kg = static_cast<btScalar>(setup.mass_kg);
    btVector3 inertia;
    shape.calculateLocalInertia(mass_kg, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(btVector3(0, 0, 0.05F));
    return info;
  }

  btScalar dt_s_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase pairs_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &pairs_, &solver_, &configuration_};
  btStaticPlaneShape plane_{btVector3(0, 0, 1), 0};
  btBoxShape shape_{btVector3(0.05F, 0.05F, 0.05F)};
  btRigidBody box_, ground_;
};

Program program(const std::string& name, bool may_sleep, const CurveStyle& style) {
  return {"Bullet" + name, style,
          [=](const BlockSetup& setup) { return std::make_unique<BulletBlock>(setup, may_sleep); }};
}

}  // namespace

std::vector<Program> bullet_programs() {
  return {program(", kept awake", false, {palette::grey, Dash::solid, Marker::triangle}),
          program(", may sleep", true, {palette::grey, Dash::dotted, Marker::cross})};
}

}  // namespace fingerpad::bench
