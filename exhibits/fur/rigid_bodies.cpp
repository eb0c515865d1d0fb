#include "exhibits/fur/rigid_bodies.h"

#include <btBulletDynamicsCommon.h>

#include <cassert>
#include <cmath>
#include <numbers>

extern btScalar gDeactivationTime;

namespace vitrine::fur {
namespace {

btVector3 bulletOf(const glm::dvec3& v)
{
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

glm::dvec3 glmOf(const btVector3& v)
{
    return {v.x(), v.y(), v.z()};
}

btTransform bulletOf(const RigidPose& pose)
{
    const auto s = [](double x) { return static_cast<btScalar>(x); };
    return btTransform(btQuaternion(s(pose.rotation.x), s(pose.rotation.y), s(pose.rotation.z), s(pose.rotation.w)),
                       bulletOf(pose.position));
}

constexpr double restitutionOfPad = 0.4;  ///< The pad is soft; floor and wall have 0.9.

using Shapes = std::vector<std::unique_ptr<btCollisionShape>>;

/// Makes a collision shape. A compound shape does not own its parts, which are added to `parts`.
std::unique_ptr<btCollisionShape> makeShape(const RigidShape& shape, Shapes& parts)
{
    const auto s = [](double x) { return static_cast<btScalar>(x); };
    if (const auto* ball = std::get_if<BallShape>(&shape)) return std::make_unique<btSphereShape>(s(ball->radius));
    if (const auto* roll = std::get_if<RollShape>(&shape))
        return std::make_unique<btCapsuleShapeX>(s(roll->radius), s(2 * roll->halfLength));
    if (const auto* hull = std::get_if<HullShape>(&shape)) {
        auto result = std::make_unique<btConvexHullShape>();
        for (const glm::dvec3& p : hull->points) result->addPoint(bulletOf(p), false);
        result->recalcLocalAabb();
        result->setMargin(s(hull->margin));
        return result;
    }
    const auto& ring = std::get<RingShape>(shape);
    constexpr int balls = 16;
    auto compound = std::make_unique<btCompoundShape>();
    for (int i = 0; i < balls; ++i) {
        const double phi = 2 * std::numbers::pi * i / balls;
        parts.push_back(std::make_unique<btSphereShape>(s(ring.tube)));
        compound->addChildShape(bulletOf(RigidPose{{ring.radius * std::cos(phi), 0, ring.radius * std::sin(phi)}}),
                                parts.back().get());
    }
    return compound;
}

}  // namespace

struct RigidBodies::World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld dynamics{&dispatcher, &broadphase, &solver, &configuration};
    Shapes shapes;
    std::vector<std::unique_ptr<btRigidBody>> still, moving;

    ~World()
    {
        for (auto& body : moving) dynamics.removeRigidBody(body.get());
        for (auto& body : still) dynamics.removeRigidBody(body.get());
    }
    btRigidBody& at(int body) { return *moving.at(static_cast<std::size_t>(body)); }

    void wall(std::unique_ptr<btCollisionShape> shape, const btTransform& where, double restitution = 0.9)
    {
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape.get());
        info.m_startWorldTransform = where;
        info.m_restitution = static_cast<btScalar>(restitution);
        info.m_friction = btScalar(0.8);
        still.push_back(std::make_unique<btRigidBody>(info));
        shapes.push_back(std::move(shape));
        dynamics.addRigidBody(still.back().get());
    }
};

RigidBodies::RigidBodies(const RigidPit& pit) : world_(std::make_unique<World>())
{
    World& w = *world_;
    const auto s = [](double x) { return static_cast<btScalar>(x); };
    w.dynamics.setGravity({0, s(-pit.gravity), 0});
    // Bullet's own 2 s are too long for a user who waits until all is still. The value is a global of the library.
    gDeactivationTime = btScalar(0.5);
    // Without this, the solver visits contacts in a random order, from its own generator.
    w.dynamics.getSolverInfo().m_solverMode &= ~SOLVER_RANDMIZE_ORDER;
    w.wall(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0)), btTransform::getIdentity());
    // The ground behind the wall consists of blocks, wide enough to leave no gap on their outer side. The pad consists
    // of as many straight pieces of a tube.
    constexpr int sides = 32;
    constexpr double ground = 8;
    for (int i = 0; i < sides; ++i) {
        const double phi = 2 * std::numbers::pi * i / sides;
        const glm::dvec3 out(std::cos(phi), 0, std::sin(phi));
        const btQuaternion turn({0, 1, 0}, s(-phi));
        w.wall(std::make_unique<btBoxShape>(
                   btVector3(s(ground / 2), s(pit.depth / 2), s(std::numbers::pi * (pit.radius + ground) / sides))),
               btTransform(turn, bulletOf(out * (pit.radius + ground / 2) + glm::dvec3(0, pit.depth / 2, 0))));
        const double middle = pit.radius + pit.padRadius;
        w.wall(std::make_unique<btCapsuleShapeZ>(s(pit.padRadius), s(2 * std::numbers::pi * middle / sides)),
               btTransform(turn, bulletOf(out * middle + glm::dvec3(0, pit.depth + pit.padLift, 0))), restitutionOfPad);
    }
}

RigidBodies::~RigidBodies() = default;

int RigidBodies::add(const RigidShape& shape, const RigidPose& pose, double mass)
{
    assert(mass > 0);
    World& w = *world_;
    std::unique_ptr<btCollisionShape> made = makeShape(shape, w.shapes);
    btVector3 inertia(0, 0, 0);
    made->calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, made.get(), inertia);
    info.m_startWorldTransform = bulletOf(pose);
    info.m_restitution = btScalar(0.72);
    info.m_friction = btScalar(0.7);
    info.m_rollingFriction = btScalar(0.02);
    info.m_spinningFriction = btScalar(0.02);
    info.m_linearDamping = btScalar(0.05);
    info.m_angularDamping = btScalar(0.25);
    info.m_linearSleepingThreshold = btScalar(0.03);
    info.m_angularSleepingThreshold = btScalar(0.06);
    w.moving.push_back(std::make_unique<btRigidBody>(info));
    w.shapes.push_back(std::move(made));
    w.dynamics.addRigidBody(w.moving.back().get());
    return static_cast<int>(w.moving.size()) - 1;
}

void RigidBodies::resizeBall(int body, double radius)
{
    assert(radius > 0);
    auto& shape = dynamic_cast<btSphereShape&>(*world_->at(body).getCollisionShape());
    if (shape.getRadius() == static_cast<btScalar>(radius)) return;
    shape.setUnscaledRadius(static_cast<btScalar>(radius));
    world_->at(body).activate();
    world_->dynamics.updateSingleAabb(&world_->at(body));
}

void RigidBodies::move(int body, const glm::dvec3& position, const glm::dvec3& velocity)
{
    btRigidBody& b = world_->at(body);
    b.getWorldTransform().setOrigin(bulletOf(position));
    b.setInterpolationWorldTransform(b.getWorldTransform());
    b.setLinearVelocity(bulletOf(velocity));
    world_->dynamics.updateSingleAabb(&b);
}

void RigidBodies::accelerate(int body, const glm::dvec3& velocity, const glm::dvec3& angularVelocity)
{
    btRigidBody& b = world_->at(body);
    b.activate(true);
    b.setLinearVelocity(b.getLinearVelocity() + bulletOf(velocity));
    b.setAngularVelocity(b.getAngularVelocity() + bulletOf(angularVelocity));
}

void RigidBodies::step(double seconds)
{
    world_->dynamics.stepSimulation(static_cast<btScalar>(seconds), 0);
}

RigidPose RigidBodies::pose(int body) const
{
    const btTransform& t = world_->at(body).getWorldTransform();
    const btQuaternion q = t.getRotation();
    return {glmOf(t.getOrigin()), glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()))};
}

glm::dvec3 RigidBodies::velocity(int body) const
{
    return glmOf(world_->at(body).getLinearVelocity());
}

glm::dvec3 RigidBodies::angularVelocity(int body) const
{
    return glmOf(world_->at(body).getAngularVelocity());
}

double RigidBodies::ballRadius(int body) const
{
    return dynamic_cast<const btSphereShape&>(*world_->at(body).getCollisionShape()).getRadius();
}

bool RigidBodies::touches(int body) const
{
    btDispatcher& dispatcher = world_->dispatcher;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& pair = *dispatcher.getManifoldByIndexInternal(i);
        if (pair.getBody0() != &world_->at(body) && pair.getBody1() != &world_->at(body)) continue;
        for (int k = 0; k < pair.getNumContacts(); ++k)
            if (pair.getContactPoint(k).getDistance() < btScalar(0.005)) return true;
    }
    return false;
}

bool RigidBodies::asleep(int body) const
{
    return !world_->at(body).isActive();
}

}  // namespace vitrine::fur
