// Pairs of elements that are bonded, touch, or may soon touch.
#pragma once

#include <cstdint>
#include <vector>

#include <grainloop/Vectors.hpp>
#include <physics/pairlaw.hpp>

namespace grus::grainloop {

/// Constants of pairs of one kind, shared by all of them.
struct PairKind {
    physics::PairConstants constants; ///< its kind tells what bond acts now
    double bondTanPhi = 0;
    int broken = -1;    ///< kind after the bond has broken; -1 without a bond
    int forgotten = -1; ///< kind after a broken pair has come apart, which then is like any other contact; else -1
};

/// Pairs sorted by their elements, smaller first. 140 bytes each (in the plane 92 of them are used), and 40 more (24)
/// when a contact can have options.
struct Pairs {
    Array<int> first, second, kind;
    Vectors normal;              ///< of the last step
    Vectors contactShear;        ///< [N]
    Vectors bondShear;           ///< [N]
    Vectors bending;             ///< [N m]
    Array<double> twist;         ///< [N m]
    Array<double> overlap0;      ///< overlap at the birth of the bond [m]
    Array<double> tensile;       ///< strength of the bond; huge without a bond
    Array<double> shear;         ///< strength of the bond; huge without a bond
    bool options = false;        ///< whether the next three are kept; see physics::ContactOptions
    Vectors rolling;             ///< moment of rolling resistance [N m]
    Array<double> lastOverlap;   ///< of the last step, since the birth of the bond [m]
    Array<double> largest;       ///< largest of these overlaps [m]
    Array<int> link;             ///< number of YADE's interaction; -1: there is none
    Array<std::int8_t> breakage; ///< how its bond broke: 0 not, 1 in tension, 2 in shear
    Array<std::int8_t> lost;     ///< 1 when it has come apart and forgotten its bond since it was linked

    std::size_t size() const { return first.size(); }
    void resize(std::size_t n);
    /// Copies pair `from` of `other` into pair `to`.
    void copy(std::size_t to, const Pairs& other, std::size_t from);
    /// Makes pair `to` a contact that carries nothing.
    void clear(std::size_t to, int one, int two, int pairKind);
};

/// Strength of a pair that has no bond to break; its square is a number, too.
constexpr double unbreakable = 1e150;

/// What the pair carries, for the functions of physics/pairlaw.hpp; `overlap` since birth of the bond.
physics::PairState pairState(const Pairs& pairs, std::size_t k, const PairKind& kind, double overlap);

}
