#include <grus/insertSpecimen.hpp>

#include <Eigen/Eigenvalues>

#include <core/Body.hpp>
#include <core/BodyContainer.hpp>
#include <core/Clump.hpp>
#include <core/InteractionContainer.hpp>
#include <core/Omega.hpp>
#include <core/Scene.hpp>
#include <pkg/common/Sphere.hpp>

#include <grus/BondState.hpp>

namespace yade {

namespace {

constexpr unsigned planeBlocked = State::DOF_Z | State::DOF_RX | State::DOF_RY;

/// Gives a body the mass and inertia of a clump, along principal axes in space and along the global axes in the plane.
void setRigid(Body& body, Real mass, const Matrix3r& inertia, bool plane) {
    State& state = *body.state;
    state.mass = mass;
    if (plane) {
        state.inertia = inertia.diagonal();
        state.blockedDOFs = planeBlocked;
        body.setAspherical(false);
        return;
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3r> principal(inertia);
    Matrix3r axes = principal.eigenvectors();
    if (axes.determinant() < 0)
        axes.col(0) *= -1;
    const Vector3r moments = principal.eigenvalues();
    const bool sphere = moments[2] - moments[0] <= 1e-12 * moments[2];
    state.inertia = moments;
    state.ori = state.refOri = sphere ? Quaternionr::Identity() : Quaternionr(axes);
    body.setAspherical(!sphere);
}

boost::shared_ptr<Body> makeElement(const SpecimenArrays& s, std::size_t i,
                                    const boost::shared_ptr<BondMat>& material) {
    boost::shared_ptr<Body> body(new Body);
    boost::shared_ptr<Sphere> sphere(new Sphere);
    sphere->radius = s.radius[i];
    body->shape = sphere;
    body->material = material;
    body->state = material->newAssocState();
    auto& state = static_cast<BondState&>(*body->state);
    state.pos = state.refPos = s.position[i];
    state.grain = s.grain[i];
    state.element = s.element[i];
    state.grainDiameter = s.grainDiameter[i];
    return body;
}

void joinClump(const std::vector<int>& members, const SpecimenArrays& s, int clump, Scene& scene, bool plane) {
    boost::shared_ptr<Body> body(new Body);
    boost::shared_ptr<Clump> shape(new Clump);
    body->shape = shape;
    body->setBounded(false);
    body->state->pos = body->state->refPos = s.clumpCentre[clump];
    setRigid(*body, s.clumpMass[clump], s.clumpInertia[clump], plane);
    scene.bodies->insert(body);
    const Quaternionr back = body->state->ori.conjugate();
    for (const int id : members) {
        const auto& member = (*scene.bodies)[id];
        Clump::add(body, member);
        Se3r& place = shape->members[id];
        place.position = back * (member->state->pos - body->state->pos);
        place.orientation = back * member->state->ori;
        // The integrator never moves a member by itself; its own mass serves output and density only.
        member->state->mass = s.clumpMass[clump] / members.size();
    }
}

}

std::vector<int> insertSpecimen(const SpecimenArrays& s, const boost::shared_ptr<BondMat>& material) {
    Scene& scene = *Omega::instance().getScene();
    const bool plane = material->thickness > 0;
    std::vector<int> ids;
    std::vector<std::vector<int>> members(s.clumpMass.size());
    for (std::size_t i = 0; i < s.position.size(); ++i) {
        ids.push_back(scene.bodies->insert(makeElement(s, i, material)));
        members[s.clump[i]].push_back(ids.back());
    }
    for (std::size_t clump = 0; clump < members.size(); ++clump) {
        if (members[clump].size() == 1)
            setRigid(*(*scene.bodies)[members[clump][0]], s.clumpMass[clump], s.clumpInertia[clump], plane);
        else if (members[clump].size() > 1)
            joinClump(members[clump], s, static_cast<int>(clump), scene, plane);
    }
    for (std::size_t pair = 0; pair < s.first.size(); ++pair)
        scene.interactions->insert(ids[s.first[pair]], ids[s.second[pair]]);
    return ids;
}

namespace {

std::vector<int> fromPython(const std::vector<Vector3r>& position, const std::vector<Real>& radius,
                            const std::vector<int>& clump, const std::vector<int>& grain,
                            const std::vector<int>& element, const std::vector<Real>& grainDiameter,
                            const std::vector<Vector3r>& clumpCentre, const std::vector<Real>& clumpMass,
                            const std::vector<Matrix3r>& clumpInertia, const std::vector<int>& first,
                            const std::vector<int>& second, const boost::shared_ptr<BondMat>& material) {
    return insertSpecimen(
        {position, radius, clump, grain, element, grainDiameter, clumpCentre, clumpMass, clumpInertia, first, second},
        material);
}

}

void exposeInsertSpecimen() {
    namespace py = boost::python;
    py::def("insertSpecimen", &fromPython,
            (py::arg("position"), py::arg("radius"), py::arg("clump"), py::arg("grain"), py::arg("element"),
             py::arg("grainDiameter"), py::arg("clumpCentre"), py::arg("clumpMass"), py::arg("clumpInertia"),
             py::arg("first"), py::arg("second"), py::arg("material")),
            "Puts a specimen's elements and clumps into the current scene; use grus.scene.insert.");
}

}
