#pragma once

#include <core/Dispatching.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondLedger.hpp>
#include <grus/BondPhys.hpp>

namespace yade {

/// Contact bonds, parallel bonds and the frictional contacts that they leave behind.
class Law2_ScGeom_BondPhys_Bonded : public LawFunctor {
public:
    virtual ~Law2_ScGeom_BondPhys_Bonded(){};
    virtual bool go(boost::shared_ptr<IGeom>& geom, boost::shared_ptr<IPhys>& phys, Interaction* interaction) override;
    FUNCTOR2D(ScGeom, BondPhys);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS(Law2_ScGeom_BondPhys_Bonded, LawFunctor,
        "Frictional contact, linear unless :yref:`BondMat` asks for more (Hertz-Mindlin stiffness, yielding asperities, rolling resistance), with an optional contact bond or parallel bond (Potyondy & Cundall 2004). A broken bond leaves an ordinary contact. Works with :yref:`ScGeom` and :yref:`ScGeom6D`, with spheres, clumps, walls, boxes and facets.",
        ((boost::shared_ptr<BondLedger>, ledger, , , "Where breakages, released energy and sliding work are booked; None: nowhere."))
    );
    // clang-format on

private:
    void book(BondPhys&, const grus::physics::PairEvents&, const Interaction&, const Vector3r& place) const;
};
REGISTER_SERIALIZABLE(Law2_ScGeom_BondPhys_Bonded);

}
