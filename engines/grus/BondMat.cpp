#include <grus/BondMat.hpp>

#include <cmath>
#include <map>

#include <grus/BondState.hpp>
#include <grus/require.hpp>

namespace yade {

namespace {

template <class Kind> using Names = std::map<std::string, Kind>;

const Names<BondMat::BondKind> bondNames{
    {"none", BondMat::None}, {"contact", BondMat::ContactBond}, {"parallel", BondMat::ParallelBond}};
const Names<bool> contactNames{{"linear", false}, {"hertz", true}};
const Names<grus::physics::StiffnessKind> stiffnessNames{{"total", grus::physics::StiffnessKind::Total},
                                                         {"area", grus::physics::StiffnessKind::PerArea},
                                                         {"modulus", grus::physics::StiffnessKind::Modulus}};
const Names<grus::physics::Scatter> scatterNames{{"none", grus::physics::Scatter::None},
                                                 {"normal", grus::physics::Scatter::Normal},
                                                 {"weibull", grus::physics::Scatter::Weibull}};

template <class Kind> void requireName(const std::string& key, const std::string& value, const Names<Kind>& names) {
    std::string allowed;
    for (const auto& name : names)
        allowed += (allowed.empty() ? "'" : ", '") + name.first + "'";
    require(names.count(value) > 0, "BondMat." + key, "'" + value + "'", allowed);
}

}

void BondMat::postLoad(BondMat&) {
    requireName("bond", bond, bondNames);
    requireName("bondStiffness", bondStiffness, stiffnessNames);
    requireName("scatter", scatter, scatterNames);
    requireName("contactLaw", contactLaw, contactNames);
    require(unloadingRatio >= 1 && std::isfinite(unloadingRatio), "BondMat.unloadingRatio", unloadingRatio,
            "1 or more");
    require(rollingStiffness >= 0 && std::isfinite(rollingStiffness), "BondMat.rollingStiffness", rollingStiffness,
            "0 or more");
    require(rollingFriction >= 0 && std::isfinite(rollingFriction), "BondMat.rollingFriction", rollingFriction,
            "0 or more");
    require(!hertz() || unloadingRatio == 1, "BondMat.unloadingRatio", unloadingRatio, "1 with contactLaw 'hertz'");
    require(bond != "contact" || !(hertz() || unloadingRatio > 1), "BondMat.bond", "'contact'",
            "'none' or 'parallel' with contactLaw 'hertz' or an unloadingRatio above 1");
    require(!hertz() || (young > 0 && poisson > -1 && poisson <= 0.5), "BondMat.young, poisson",
            std::to_string(young) + ", " + std::to_string(poisson),
            "young more than 0 and poisson above -1, at most 0.5, with contactLaw 'hertz'; set them first");
    require(std::isfinite(kn), "BondMat.kn", kn, "a finite number");
    require(std::isfinite(ks), "BondMat.ks", ks, "a finite number");
    const bool scattered = scatterKind() != grus::physics::Scatter::None;
    require(!scattered || scatterParameter > 0, "BondMat.scatterParameter", scatterParameter,
            "more than 0 with scatter '" + scatter + "'; set it first");
    require(scatter != "normal" || scatterParameter < 1, "BondMat.scatterParameter", scatterParameter,
            "below 1 with scatter 'normal'");
    require(bondKn >= 0 && std::isfinite(bondKn), "BondMat.bondKn", bondKn, "0 or more");
    require(bondKs >= 0 && std::isfinite(bondKs), "BondMat.bondKs", bondKs, "0 or more");
    require(bondRadiusRatio > 0, "BondMat.bondRadiusRatio", bondRadiusRatio, "more than 0");
    require(momentContribution >= 0 && momentContribution <= 1, "BondMat.momentContribution", momentContribution,
            "0 to 1");
    require(tensileStrength >= 0, "BondMat.tensileStrength", tensileStrength, "0 or more");
    require(shearStrength >= 0, "BondMat.shearStrength", shearStrength, "0 or more");
    require(bondFrictionAngle >= 0 && bondFrictionAngle < M_PI / 2, "BondMat.bondFrictionAngle", bondFrictionAngle,
            "0 to below pi/2");
    require(scatterParameter >= 0, "BondMat.scatterParameter", scatterParameter, "0 or more");
    require(grainModulus >= 0, "BondMat.grainModulus", grainModulus, "0 or more");
    require(grainReferenceDiameter >= 0, "BondMat.grainReferenceDiameter", grainReferenceDiameter, "0 or more");
    require(thickness >= 0, "BondMat.thickness", thickness, "0 or more");
}

boost::shared_ptr<State> BondMat::newAssocState() const { return boost::shared_ptr<State>(new BondState); }

bool BondMat::stateTypeOk(State* state) const { return dynamic_cast<BondState*>(state) != nullptr; }

BondMat::BondKind BondMat::bondKind() const { return bondNames.at(bond); }

grus::physics::StiffnessKind BondMat::stiffnessKind() const { return stiffnessNames.at(bondStiffness); }

grus::physics::Scatter BondMat::scatterKind() const { return scatterNames.at(scatter); }

YADE_PLUGIN((BondMat));

}
