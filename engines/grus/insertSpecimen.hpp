#pragma once

#include <vector>

#include <lib/base/Math.hpp>

#include <grus/BondMat.hpp>

namespace yade {

/// Elements and clumps of a specimen as plain lists; see grus.specimen.
struct SpecimenArrays {
    std::vector<Vector3r> position;     ///< centres of the elements [m]
    std::vector<Real> radius;           ///< [m]
    std::vector<int> clump;             ///< number of the clump that the element belongs to
    std::vector<int> grain;             ///< number of the grain
    std::vector<int> element;           ///< number of the element within its grain
    std::vector<Real> grainDiameter;    ///< diameter of the element's grain [m]
    std::vector<Vector3r> clumpCentre;  ///< centres of mass of the clumps [m]
    std::vector<Real> clumpMass;        ///< [kg]
    std::vector<Matrix3r> clumpInertia; ///< inertia tensors about the centres of mass [kg m2]
    std::vector<int> first, second;     ///< numbers of the elements of pairs that will interact all the time
};

/// Puts the elements into the current scene and joins them to rigid clumps with exactly the given mass and inertia; an
/// element alone in its clump stays a single body. In the plane (material thickness > 0) z, X, Y are blocked.
/// The pairs become potential contacts at once, so that they lie in memory in the order of a loop over them.
/// Returns the ids of the elements in their order.
std::vector<int> insertSpecimen(const SpecimenArrays& specimen, const boost::shared_ptr<BondMat>& material);

/// Defines insertSpecimen in the Python module that is being made.
void exposeInsertSpecimen();

}
