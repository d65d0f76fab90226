#include <grus/BondMat.hpp>

#include <map>
#include <stdexcept>

#include <grus/BondState.hpp>

namespace yade {

namespace {

template <class Kind> using Names = std::map<std::string, Kind>;

const Names<BondMat::BondKind> bondNames{
    {"none", BondMat::None}, {"contact", BondMat::ContactBond}, {"parallel", BondMat::ParallelBond}};
const Names<grus::physics::StiffnessKind> stiffnessNames{{"total", grus::physics::StiffnessKind::Total},
                                                         {"area", grus::physics::StiffnessKind::PerArea},
                                                         {"modulus", grus::physics::StiffnessKind::Modulus}};
const Names<grus::physics::Scatter> scatterNames{{"none", grus::physics::Scatter::None},
                                                 {"normal", grus::physics::Scatter::Normal},
                                                 {"weibull", grus::physics::Scatter::Weibull}};

template <class Kind> void checkName(const char* key, const std::string& value, const Names<Kind>& names) {
    if (names.count(value))
        return;
    std::string allowed;
    for (const auto& name : names)
        allowed += (allowed.empty() ? "'" : ", '") + name.first + "'";
    throw std::invalid_argument("BondMat." + std::string(key) + " = '" + value + "'; allowed: " + allowed);
}

void check(const char* key, Real value, bool good, const char* allowed) {
    if (good)
        return;
    throw std::invalid_argument("BondMat." + std::string(key) + " = " + std::to_string(value) +
                                "; allowed: " + allowed);
}

}

void BondMat::postLoad(BondMat&) {
    checkName("bond", bond, bondNames);
    checkName("bondStiffness", bondStiffness, stiffnessNames);
    checkName("scatter", scatter, scatterNames);
    check("bondKn", bondKn, bondKn >= 0, "0 or more");
    check("bondKs", bondKs, bondKs >= 0, "0 or more");
    check("bondRadiusRatio", bondRadiusRatio, bondRadiusRatio > 0, "more than 0");
    check("momentContribution", momentContribution, momentContribution >= 0 && momentContribution <= 1, "0 to 1");
    check("tensileStrength", tensileStrength, tensileStrength >= 0, "0 or more");
    check("shearStrength", shearStrength, shearStrength >= 0, "0 or more");
    check("bondFrictionAngle", bondFrictionAngle, bondFrictionAngle >= 0 && bondFrictionAngle < M_PI / 2,
          "0 to below pi/2");
    check("scatterParameter", scatterParameter, scatterParameter >= 0, "0 or more");
    check("grainModulus", grainModulus, grainModulus >= 0, "0 or more");
    check("grainReferenceDiameter", grainReferenceDiameter, grainReferenceDiameter >= 0, "0 or more");
    check("thickness", thickness, thickness >= 0, "0 or more");
}

boost::shared_ptr<State> BondMat::newAssocState() const { return boost::shared_ptr<State>(new BondState); }

bool BondMat::stateTypeOk(State* state) const { return dynamic_cast<BondState*>(state) != nullptr; }

BondMat::BondKind BondMat::bondKind() const { return bondNames.at(bond); }

grus::physics::StiffnessKind BondMat::stiffnessKind() const { return stiffnessNames.at(bondStiffness); }

grus::physics::Scatter BondMat::scatterKind() const { return scatterNames.at(scatter); }

YADE_PLUGIN((BondMat));

}
