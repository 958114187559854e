// ode SHOTS
#include "harness.hpp"
#include <ode/ode.h>

class World {
    dWorldID world = dWorldCreate();
    dSpaceID space;
    dJointGroupID contacts = dJointGroupCreate(0);
    std::vector<dBodyID> bodies;
    bool rolling;

    static void near(void *data, dGeomID a, dGeomID b) {
        auto *self = static_cast<World *>(data);
        dContact contact[4];
        int n = dCollide(a, b, 4, &contact[0].geom, sizeof(dContact));
        for (int i = 0; i < n; i++) {
            // dContactApprox1 makes friction proportional to the normal force.
            contact[i].surface = {};
            contact[i].surface.mode = dContactBounce | dContactApprox1 | (self->rolling ? dContactRolling : 0);
            contact[i].surface.mu = kFriction;
            contact[i].surface.bounce = kRestitution;
            contact[i].surface.bounce_vel = 0.1;
            contact[i].surface.rho = contact[i].surface.rho2 = kRollingArm;
            dJointAttach(dJointCreateContact(self->world, self->contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
        }
    }

public:
    explicit World(const Options &o) : rolling(o.rolling) {
        // The manual: a simple space for few objects.
        space = o.count > 1 ? dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY) : dSimpleSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, -kGravity, 0);
        auto fix = [](dGeomID geom) {
            dGeomSetCategoryBits(geom, 2);
            dGeomSetCollideBits(geom, 1);
        };
        if (o.ground) fix(dCreatePlane(space, 0, 1, 0, 0));
        if (o.post) {
            dGeomID post = dCreateCapsule(space, kPostRadius, kPostHeight);
            dMatrix3 r;
            dRFromAxisAndAngle(r, 1, 0, 0, M_PI / 2);
            dGeomSetRotation(post, r);
            dGeomSetPosition(post, 0, kPostHeight / 2, kPostZ);
            fix(post);
        }
    }

    World(const World &) = delete;

    ~World() {
        dJointGroupDestroy(contacts);
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }

    void add(Vec p, Vec v, Vec w) {
        dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetParameters(&mass, kMass, 0, 0, 0, kInertia, kInertia, kInertia, 0, 0, 0);
        dBodySetMass(body, &mass);
        dGeomID sphere = dCreateSphere(space, kRadius);
        dGeomSetBody(sphere, body);
        dGeomSetCategoryBits(sphere, 1);
        dGeomSetCollideBits(sphere, 2);
        dBodySetPosition(body, p[0], p[1], p[2]);
        dBodySetLinearVel(body, v[0], v[1], v[2]);
        dBodySetAngularVel(body, w[0], w[1], w[2]);
        bodies.push_back(body);
    }

    void step(double h) {
        dSpaceCollide(space, this, &near);
        // The manual: the most accurate method. It is slow for large islands only; each ball is its own island.
        dWorldStep(world, h);
        dJointGroupEmpty(contacts);
    }

    State get(int i) {
        const dReal *p = dBodyGetPosition(bodies[i]), *q = dBodyGetQuaternion(bodies[i]);
        const dReal *v = dBodyGetLinearVel(bodies[i]), *w = dBodyGetAngularVel(bodies[i]);
        return {p[0], p[1], p[2], q[0], q[1], q[2], q[3], v[0], v[1], v[2], w[0], w[1], w[2]};
    }

    void set(int i, const State &s) {
        dBodySetPosition(bodies[i], s[0], s[1], s[2]);
        const dQuaternion q = {s[3], s[4], s[5], s[6]};
        dBodySetQuaternion(bodies[i], q);
        dBodySetLinearVel(bodies[i], s[7], s[8], s[9]);
        dBodySetAngularVel(bodies[i], s[10], s[11], s[12]);
    }

    State save() { return get(0); }

    void restore(const State &saved) { set(0, saved); }
};

int main(int, char **args) {
    dInitODE2(0);
    Harness<World>(args[1]).run({"ODE", PACKAGE_VERSION, "C++, double", false, true}, 13 * sizeof(dReal));
    dCloseODE();
}
