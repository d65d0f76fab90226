// Two spheres joined by a parallel bond and moved by prescribed velocities: the smallest host of the bond functions.
#pragma once

#include <physics/bond.hpp>
#include <physics/transport.hpp>

namespace grus::physics::test {

struct Ball {
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), rate = Vec3::Zero();
};

struct Pair {
    Ball a, b;
    double radiusA = 1.0, radiusB = 1.0;
    BondStiffness stiffness{3.0, 2.0, 0.7, 0.5};
    double overlap0 = 0;
    BondLoad load;
    Vec3 lastNormal = Vec3::Zero();

    Vec3 normal() const { return (b.position - a.position).normalized(); }

    double overlap() const { return radiusA + radiusB - (b.position - a.position).norm(); }

    void bond() {
        overlap0 = overlap();
        lastNormal = normal();
        load = {};
    }

    /// Moves both balls for `dt` and updates the bond from the motion in that step.
    void step(double dt) {
        for (Ball* ball : {&a, &b})
            ball->position += dt * ball->velocity;
        const Vec3 n = normal();
        const Vec3 relative = b.velocity - b.rate.cross(radiusB * n) - a.velocity - a.rate.cross(radiusA * n);
        const double roll = 0.5 * dt * n.dot(a.rate + b.rate);
        load.shear = transport(load.shear, lastNormal, n, roll);
        load.bending = transport(load.bending, lastNormal, n, roll);
        lastNormal = n;
        deform(load, stiffness, overlap() - overlap0, across(relative, n) * dt, (a.rate - b.rate) * dt, n);
    }

    Vec3 forceOnB() const { return load.normal * normal() + load.shear; }

    Vec3 momentOnB() const { return load.bending + load.twist * normal(); }
};

}
