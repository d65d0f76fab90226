// What the loops over a block of pairs hand on to each other.
#pragma once

#include <cstdint>

#include <grainloop/Vectors.hpp>

namespace grus::grainloop {

/// Pairs that are worked on at a time; what they pass on stays in the first cache.
constexpr int blockSize = 64;

/// Columns of numbers, all with a cache line more than they need, so that they do not begin at the same place of a
/// page, and integers as long as numbers, so that as many fit into a register.
struct alignas(64) PairBlock {
    static constexpr int size = blockSize + 8;
    struct Column {
        double x[size], y[size], z[size];
    };
    std::int64_t first[size], second[size];
    std::int64_t row[size];     ///< of its kind in the table
    std::int64_t forgets[size]; ///< 1 when its kind forgets its bond as it comes apart

    Column normal;                 ///< from first to second
    Column slip;                   ///< of the second against the first [m]
    Column rotation;               ///< of the first against the second [rad]
    double roll[size];             ///< mean rotation about the normal [rad]
    double penetration[size];      ///< overlap of the two elements [m]
    double arm1[size], arm2[size]; ///< from the centres to the contact point [m]

    Column contactShear, bondShear, bending;
    double twist[size];
    Column force;            ///< on the second element [N]
    Column moment1, moment2; ///< on both [N m]
    double sliding[size];    ///< work lost in the contact [J]
    /// 1 for a pair that needs the scalar law, because its bond may break or it comes apart; it is left as it was.
    std::int64_t event[size];
    bool anyEvent;
    double slidingWork; ///< of all [J]

    // Of contacts with options only:
    Column rolling;                      ///< moment on the second element [N m]
    double overlap[size], largest[size]; ///< [m]
};

inline Components<double> components(PairBlock::Column& c) { return {c.x, c.y, c.z}; }
inline Components<const double> components(const PairBlock::Column& c) { return {c.x, c.y, c.z}; }

}
