// Plane walls normal to an axis, and their contacts with elements.
#pragma once

#include <cstdint>
#include <vector>

#include <grainloop/Elements.hpp>
#include <grainloop/Forces.hpp>
#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// A wall; it moves as it is told.
struct Wall {
    int axis = 0;
    int sense = 0; ///< side that makes contacts: -1 below, 1 above, 0 both
    int kind = 0;  ///< as Elements::kind: its material
    int mask = 1;
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero(); ///< about its position
};

/// A wall and an element that touch or may soon touch.
struct WallContact {
    int wall = 0, element = 0, kind = 0;
    physics::PairState state;
    int link = -1; ///< number of YADE's interaction; -1: there is none
    bool touches = false;
};

/// Normal of a contact, from wall to element, and distance along it of the element's centre.
struct WallGeometry {
    Vec3 normal;
    double distance; ///< negative when the centre is behind a one-sided wall
    double penetration;
};

WallGeometry wallGeometry(const Wall& wall, const Vec3& centre, double radius);

/// Contacts with a gap below `gap`, in the order of walls, then elements; what is in `old` (in the same order) is kept.
/// `kindOf(wall, element)` gives the kind of a new one.
template <class KindOf>
std::vector<WallContact> wallContacts(const std::vector<Wall>& walls, const Elements& e, double gap,
                                      const std::vector<WallContact>& old, KindOf kindOf) {
    std::vector<WallContact> contacts;
    std::size_t next = 0;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        for (int i = 0; i < static_cast<int>(e.size()); ++i) {
            const bool known = next < old.size() && old[next].wall == w && old[next].element == i;
            const bool near =
                wallGeometry(walls[w], e.position[i], e.radius[i]).penetration > -gap && (walls[w].mask & e.mask[i]);
            if (known && (near || old[next].touches))
                contacts.push_back(old[next]);
            else if (near) {
                contacts.emplace_back();
                contacts.back().wall = w;
                contacts.back().element = i;
                contacts.back().kind = kindOf(w, i);
            }
            next += known;
        }
    return contacts;
}

/// One step of all contacts; adds to the forces of `thread` and to those of the walls. Returns the work lost in
/// them [J].
double stepWalls(std::vector<Wall>& walls, std::vector<WallContact>& contacts, const std::vector<PairKind>& kinds,
                 const Elements& elements, double dt, Forces& forces, int thread);

}
