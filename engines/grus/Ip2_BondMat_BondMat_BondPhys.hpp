#pragma once

#include <atomic>

#include <core/Dispatching.hpp>

#include <grus/BondMat.hpp>
#include <grus/BondPhys.hpp>

namespace yade {

/// Makes the contacts of grains and, while `bonding` is on, the bonds inside them.
class Ip2_BondMat_BondMat_BondPhys : public IPhysFunctor {
public:
    virtual ~Ip2_BondMat_BondMat_BondPhys(){};
    virtual void go(const boost::shared_ptr<Material>& m1, const boost::shared_ptr<Material>& m2,
                    const boost::shared_ptr<Interaction>& interaction) override;
    FUNCTOR2D(BondMat, BondMat);

    /// A contact without a bond of two bodies with these materials and radii [m].
    static boost::shared_ptr<BondPhys> contact(const BondMat& a, Real radiusA, const BondMat& b, Real radiusB);

    /// Contacts that became real in this process, in all scenes.
    static std::atomic<long> made;

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS(Ip2_BondMat_BondMat_BondPhys, IPhysFunctor,
        "Makes :yref:`BondPhys` from two :yref:`BondMat`. While :yref:`bonding<Ip2_BondMat_BondMat_BondPhys.bonding>` is on, two elements of one grain and one material that touch are bonded where they stand, without any force. Needs :yref:`ScGeom`.",
        ((bool, bonding, false, , "Bond the new contacts of this step. Switch on, run one step with an interactionDetectionFactor slightly above 1, switch off."))
        ((Real, tolerance, 1e-6, , "Largest gap that is still bonded, over the smaller radius [-]."))
    );
    // clang-format on

private:
    void bond(BondPhys& phys, const BondMat& material, const Interaction& interaction) const;
};
REGISTER_SERIALIZABLE(Ip2_BondMat_BondMat_BondPhys);

}
