// W3: the chains as rigid bodies on springs, 24 frames from rest, as models for MMD have their hair.
//
//   tuftwave_bench_bullet FOLDER      with w1.json and w2.json
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "measure.hpp"
#include "workloads.hpp"

namespace {

using namespace tuftwave::bench;

constexpr int kFrames = 24, kStepsPerFrame = 3;                                         // 72 Hz
constexpr btScalar kMass = 0.02F, kRadius = 0.004F, kStiffness = 0.05F, kSwing = 0.5F;  // kg, m, N m/rad, rad
constexpr btScalar kRepair = 0.8F;      ///< share of a joint's gap that a step closes
constexpr btScalar kWidestGap = 0.01F;  ///< metres, between two bones of 2 cm; beyond it the simulation has failed

btVector3 to_bullet(const Point& point) {
    return {static_cast<btScalar>(point[0]), static_cast<btScalar>(point[1]), static_cast<btScalar>(point[2])};
}

/// A world with every chain in it, and what the world does not own.
class World {
  public:
    explicit World(const std::vector<Line>& chains) {
        world_.setGravity({0, -9.8F, 0});
        world_.getSolverInfo().m_erp = kRepair;
        for (const Line& chain : chains) add(chain);
    }
    ~World() {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// The local transforms' rotations of all bodies, frame by frame.
    std::vector<btQuaternion> run() {
        std::vector<btQuaternion> keys;
        for (int frame = 0; frame < kFrames; ++frame) {
            const btScalar turn = 0.17F * std::sin(2 * SIMD_PI * static_cast<btScalar>(frame) / kFrames);
            const btTransform head(btQuaternion({0, 1, 0}, turn));
            for (std::size_t i = 0; i < roots_.size(); ++i)
                roots_[i]->getMotionState()->setWorldTransform(head * at_rest_[i]);
            for (int step = 0; step < kStepsPerFrame; ++step)
                world_.stepSimulation(1.0F / (24 * kStepsPerFrame), 1, 1.0F / (24 * kStepsPerFrame));
            for (const auto& body : bodies_) keys.push_back(body->getWorldTransform().getRotation());
        }
        return keys;
    }

    /// Whether every joint still holds its two bones together.
    bool is_whole() const {
        for (const auto& joint : joints_) {
            const btVector3 a = joint->getRigidBodyA().getWorldTransform() * joint->getFrameOffsetA().getOrigin();
            const btVector3 b = joint->getRigidBodyB().getWorldTransform() * joint->getFrameOffsetB().getOrigin();
            if (!((a - b).length() < kWidestGap)) return false;
        }
        return true;
    }

  private:
    void add(const Line& chain) {
        btRigidBody* before = add_body(to_bullet(chain.front()), 0.001F, 0);
        before->setCollisionFlags(before->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        before->setActivationState(DISABLE_DEACTIVATION);
        roots_.push_back(before);
        at_rest_.push_back(before->getWorldTransform());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const btVector3 start = to_bullet(chain[i]), end = to_bullet(chain[i + 1]), middle = (start + end) / 2;
            btRigidBody* body = add_body(middle, (end - start).length(), kMass);
            join(*before, *body, start);
            before = body;
        }
    }

    btRigidBody* add_body(const btVector3& at, btScalar length, btScalar mass) {
        shapes_.push_back(std::make_unique<btCapsuleShape>(kRadius, length));
        states_.push_back(std::make_unique<btDefaultMotionState>(btTransform(btQuaternion::getIdentity(), at)));
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shapes_.back()->calculateLocalInertia(mass, inertia);
        bodies_.push_back(std::make_unique<btRigidBody>(mass, states_.back().get(), shapes_.back().get(), inertia));
        bodies_.back()->setDamping(0.5F, 0.9F);
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(bodies_.back().get(), 1, 0);  // strands go through each other
        return bodies_.back().get();
    }

    void join(btRigidBody& before, btRigidBody& body, const btVector3& at) {
        const btTransform frame(btQuaternion::getIdentity(), at);
        joints_.push_back(
            std::make_unique<btGeneric6DofSpringConstraint>(before, body, before.getWorldTransform().inverse() * frame,
                                                            body.getWorldTransform().inverse() * frame, true));
        btGeneric6DofSpringConstraint& joint = *joints_.back();
        joint.setLinearLowerLimit({0, 0, 0});
        joint.setLinearUpperLimit({0, 0, 0});
        joint.setAngularLowerLimit({-kSwing, -kSwing, -kSwing});
        joint.setAngularUpperLimit({kSwing, kSwing, kSwing});
        for (int axis = 3; axis < 6; ++axis) {
            joint.enableSpring(axis, true);
            joint.setStiffness(axis, kStiffness);
        }
        world_.addConstraint(&joint, true);
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCapsuleShape>> shapes_;
    std::vector<std::unique_ptr<btDefaultMotionState>> states_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btGeneric6DofSpringConstraint>> joints_;
    std::vector<btRigidBody*> roots_;
    std::vector<btTransform> at_rest_;
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fputs("usage: tuftwave_bench_bullet FOLDER\n", stderr), 2;
    const std::vector<Line> chains = read_workloads(arguments[1]).chains;
    World tried(chains);
    keep(tried.run());
    if (!tried.is_whole()) return std::fputs("tuftwave_bench_bullet: the chains fell apart\n", stderr), 1;
    measure("w3/bullet", [&] {
        World world(chains);
        keep(world.run());
    });
}
