#include <grainloop/Walls.hpp>

#include <cmath>

#include <physics/kinematics.hpp>

namespace grus::grainloop {

WallGeometry wallGeometry(const Wall& wall, const Vec3& centre, double radius) {
    const double side = centre[wall.axis] - wall.position[wall.axis];
    WallGeometry g;
    g.normal = Vec3::Zero();
    g.normal[wall.axis] = wall.sense != 0 ? wall.sense : side > 0 ? 1 : -1;
    g.distance = side * g.normal[wall.axis];
    g.penetration = radius - std::abs(side);
    return g;
}

double stepWalls(std::vector<Wall>& walls, std::vector<WallContact>& contacts, const std::vector<PairKind>& kinds,
                 const Elements& e, double dt, Forces& forces, int thread) {
    using namespace physics;
    double sliding = 0;
    for (Wall& wall : walls)
        wall.force = wall.moment = Vec3::Zero();
    for (WallContact& contact : contacts) {
        Wall& wall = walls[contact.wall];
        const int i = contact.element;
        const Vec3 centre = e.position[i], rate = e.rate[i];
        const WallGeometry g = wallGeometry(wall, centre, e.radius[i]);
        if (g.penetration < 0 && !contact.touches)
            continue;
        contact.touches = g.penetration >= 0;
        // YADE gives the wall the radius of the element.
        const double r = e.radius[i];
        const PairMotion motion{
            g.penetration,
            slip(wall.velocity, Vec3::Zero(), r, e.velocity[i], rate, r, 2 * r - g.penetration, g.normal, dt),
            -rate * dt, g.normal, 0.5 * dt * g.normal.dot(rate)};
        const PairEvents events = stepPair(contact.state, kinds[contact.kind].constants, {}, motion);
        sliding += events.sliding;
        if (!contact.touches) {
            contact.state = {};
            continue;
        }
        const Vec3 force = pairForce(contact.state, g.normal), moment = pairMoment(contact.state, g.normal);
        Vec3 point = centre;
        point[wall.axis] = wall.position[wall.axis];
        forces.add(thread, i, force, cross(point - centre, force) + moment);
        wall.force -= force;
        wall.moment -= cross(point - wall.position, force) + moment;
    }
    return sliding;
}

}
