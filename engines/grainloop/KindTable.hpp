// The kinds of pairs as a table of numbers that the inner loop reads.
#pragma once

#include <vector>

#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// One row of numbers for all kinds that compute alike.
class KindTable {
public:
    enum Column {
        Kn,
        Ks,
        HalfCompliance, ///< of the contact's shear spring
        TanPhi,
        BondKn,
        BondKs,
        BondKb,
        BondKt,
        RimForce,
        RimBending,
        RimTwist,
        BondTanPhi,
        Glued, ///< 1 with a contact bond
        plainWidth,
        // With options:
        UnloadingKn = plainWidth,
        PlasticShare, ///< of the largest overlap
        HertzNormal,
        HertzShear,
        RollingStiffness, ///< over the shear stiffness
        RollingArm,
        Bonded, ///< 1 with a bond of either kind
        width
    };

    explicit KindTable(const std::vector<PairKind>& kinds = {});
    const double* data() const { return numbers.data(); }
    int rowOf(int kind) const { return rows[kind]; }
    /// Whether a pair of this kind forgets its bond when it comes apart.
    bool forgets(int kind) const { return forgetful[kind]; }

private:
    std::vector<double> numbers;
    std::vector<int> rows;
    std::vector<char> forgetful;
};

}
