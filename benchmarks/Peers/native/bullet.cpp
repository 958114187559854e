// bullet SHOTS
#include "harness.hpp"
#include <btBulletDynamicsCommon.h>
#include <memory>

class World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btStaticPlaneShape plane{btVector3(0, 1, 0), 0};
    btCapsuleShape capsule{kPostRadius, kPostHeight};
    btSphereShape sphere{kRadius};
    std::vector<std::unique_ptr<btRigidBody>> fixed, bodies;
    bool ccd, rolling;

    // For restitution, Bullet's author turns off contacts ahead of the surface, warm starting and the threshold of speed (bullet3, issue 3094).
    // The split impulse corrects every penetration: by default, depths below 0.04 m add speed to the bounce.
    void setUpContacts() {
        btContactSolverInfo &solver = world.getSolverInfo();
        solver.m_splitImpulsePenetrationThreshold = 0;
        solver.m_restitutionVelocityThreshold = 0;
        solver.m_warmstartingFactor = 0;
    }

    // Bullet multiplies the coefficients of the two bodies: the ball has the values, the surfaces have 1.
    void fix(btCollisionShape &shape, btVector3 at) {
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, &shape);
        info.m_startWorldTransform.setOrigin(at);
        info.m_restitution = 1;
        info.m_friction = 1;
        fixed.push_back(std::make_unique<btRigidBody>(info));
        fixed.back()->setContactProcessingThreshold(0);
        world.addRigidBody(fixed.back().get(), 2, 1);
    }

public:
    explicit World(const Options &o) : ccd(o.ccd), rolling(o.rolling) {
        world.setGravity(btVector3(0, -kGravity, 0));
        setUpContacts();
        if (o.ground) fix(plane, btVector3(0, 0, 0));
        if (o.post) fix(capsule, btVector3(0, kPostHeight / 2, kPostZ));
    }

    ~World() {
        for (auto &body : bodies) world.removeRigidBody(body.get());
        for (auto &body : fixed) world.removeRigidBody(body.get());
    }

    void add(Vec p, Vec v, Vec w) {
        btRigidBody::btRigidBodyConstructionInfo info(kMass, nullptr, &sphere, btVector3(kInertia, kInertia, kInertia));
        info.m_startWorldTransform.setOrigin(btVector3(p[0], p[1], p[2]));
        info.m_restitution = kRestitution;
        info.m_friction = kFriction;
        if (rolling) info.m_rollingFriction = kRollingArm;
        bodies.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody &body = *bodies.back();
        body.setLinearVelocity(btVector3(v[0], v[1], v[2]));
        body.setAngularVelocity(btVector3(w[0], w[1], w[2]));
        body.setContactProcessingThreshold(0);
        if (ccd) {
            // The manual: a motion threshold, and an embedded sphere that is smaller than the shape.
            body.setCcdMotionThreshold(kRadius);
            body.setCcdSweptSphereRadius(0.9 * kRadius);
        }
        world.addRigidBody(&body, 1, 2);
    }

    // No substeps: the step is fixed already.
    void step(double h) { world.stepSimulation(h, 0); }

    State get(int i) {
        const btTransform &t = bodies[i]->getWorldTransform();
        btQuaternion q = t.getRotation();
        btVector3 p = t.getOrigin(), v = bodies[i]->getLinearVelocity(), w = bodies[i]->getAngularVelocity();
        return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
    }

    void set(int i, const State &s) {
        btTransform t(btQuaternion(s[3], s[4], s[5], s[6]), btVector3(s[0], s[1], s[2]));
        bodies[i]->setWorldTransform(t);
        bodies[i]->setInterpolationWorldTransform(t);
        bodies[i]->setLinearVelocity(btVector3(s[7], s[8], s[9]));
        bodies[i]->setAngularVelocity(btVector3(s[10], s[11], s[12]));
        bodies[i]->activate(true);
    }

    // The matrix of the transform, not a quaternion: the conversion would round.
    struct Saved {
        btTransform transform;
        btVector3 velocity, spin;
    };

    Saved save() { return {bodies[0]->getWorldTransform(), bodies[0]->getLinearVelocity(), bodies[0]->getAngularVelocity()}; }

    void restore(const Saved &s) {
        bodies[0]->setWorldTransform(s.transform);
        bodies[0]->setInterpolationWorldTransform(s.transform);
        bodies[0]->setLinearVelocity(s.velocity);
        bodies[0]->setAngularVelocity(s.spin);
        bodies[0]->activate(true);
    }
};

int main(int, char **args) {
    Harness<World>(args[1]).run({"Bullet", PACKAGE_VERSION, sizeof(btScalar) == 8 ? "C++, double" : "C++, single", true, true}, 18 * sizeof(btScalar));
}
