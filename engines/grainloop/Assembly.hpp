// A whole assembly of elements, bodies, pairs and walls, and the two halves of a step.
#pragma once

#include <functional>
#include <vector>

#include <grainloop/Elements.hpp>
#include <grainloop/Forces.hpp>
#include <grainloop/Pairs.hpp>
#include <grainloop/Walls.hpp>
#include <grainloop/bodyKernel.hpp>
#include <grainloop/KindTable.hpp>
#include <grainloop/PairBlock.hpp>

namespace grus::grainloop {

/// A bond that broke.
struct Broken {
    int pair;
    physics::Breakage mode;
    double released; ///< [J]
    Vec3 place;      ///< [m]
};

/// Energies that leave the assembly in a step [J].
struct Losses {
    double sliding = 0, damped = 0, gravity = 0;
};

class Assembly {
public:
    int dim = 3; ///< 2: plane normal to z
    Elements elements;
    Bodies bodies;
    Pairs pairs;
    std::vector<PairKind> kinds;
    std::vector<Wall> walls;
    std::vector<WallContact> wallContacts;
    Forces forces;
    std::vector<Broken> broken; ///< in the last step, in the order of pairs

    /// Kind of a contact of two elements that never were bonded, or of a wall and an element, by their own kinds.
    std::function<int(int element, int other)> pairKind;
    std::function<int(int wall, int element)> wallKind;

    /// Call when everything is in place, and again when kinds or pairs were changed from outside.
    void prepare(int threads);

    /// Finds the pairs that can touch before anything has moved by half the `skin` [m].
    void search(double skin);
    /// Whether something may have moved by half the skin since the search.
    bool stale();

    /// Forces on all elements and walls where they are now; bonds break, contacts slide.
    void computeForces(double dt, Losses& losses);
    /// Moves all bodies and walls.
    void move(const Motion& motion, Losses& losses);

    double elasticEnergy() const;
    double kineticEnergy() const;
    /// Mean resultant force on the bodies over mean contact force, as unbalancedForce tells it.
    double unbalancedForce() const;
    /// Sum of the contact stiffnesses of a wall [N/m].
    double contactStiffness(int wall) const;

    double overlap(std::size_t pair) const; ///< of the two elements [m]
    /// Whether the pair is bonded or touches.
    bool real(std::size_t pair) const;

private:
    struct Share { // of a thread
        int pairBegin = 0, pairEnd = 0, bodyBegin = 0, bodyEnd = 0;
        int elementBegin = 0, elementEnd = 0;
        std::vector<Broken> broken;
        double sliding = 0;
        Moved moved;
    };
    void divide();
    void stepShare(int thread, double dt);
    void settle(int k, PairBlock& block, int slot, double dt, Share& share);
    double farthest() const;

    KindTable table;
    std::vector<Share> shares;
    Vectors searched; ///< positions of the elements at the last search
    std::vector<Vec3> searchedWalls;
    double slack = -1;   ///< that may still be travelled before the next look [m]
    double halfSkin = 0; ///< [m]
};

}
