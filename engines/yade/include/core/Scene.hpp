#pragma once

#include <cstdint>

#include <lib/serialization/Serializable.hpp>

#include <core/BodyContainer.hpp>
#include <core/Cell.hpp>
#include <core/EnergyTracker.hpp>
#include <core/Engine.hpp>
#include <core/ForceContainer.hpp>
#include <core/InteractionContainer.hpp>
#include <core/Material.hpp>

namespace yade {

class DisplayParameters;
class OpenGLRenderer;

/// Everything that belongs to one simulation.
class Scene : public Serializable {
public:
    const unsigned int hostNameMax;
    ForceContainer forces;
    Eigen::Matrix<Real, 10, 1> SpeedElements;
    boost::shared_ptr<OpenGLRenderer> renderer;
    std::int64_t prevTime; // a time stamp that only YADE reads
    Real dt;
    long iter;
    bool subStepping;
    int subStep;
    Real time;
    Real speed;
    long stopAtIter;
    Real stopAtTime;
    bool isPeriodic;
    bool trackEnergy;
    bool doSort;
    bool runInternalConsistencyChecks;
    Body::id_t selectedBody;
    int subdomain;
    boost::shared_ptr<Shape> subD;
    std::vector<std::string> tags;
    std::vector<boost::shared_ptr<Engine>> engines;
    std::vector<boost::shared_ptr<Engine>> _nextEngines;
    boost::shared_ptr<BodyContainer> bodies;
    boost::shared_ptr<InteractionContainer> interactions;
    boost::shared_ptr<EnergyTracker> energy;
    std::vector<boost::shared_ptr<Material>> materials;
    boost::shared_ptr<Bound> bound;
    boost::shared_ptr<Cell> cell;
    std::vector<boost::shared_ptr<Serializable>> miscParams;
    std::vector<boost::shared_ptr<DisplayParameters>> dispParams;

    Scene();
    YADE_HOST_CLASS(Scene)
    /// Its number in the scene, which is also given to the material.
    int addMaterial(boost::shared_ptr<Material> material) {
        material->id = static_cast<int>(materials.size());
        materials.push_back(material);
        return material->id;
    }
    bool timeStepperPresent();
    bool timeStepperActive();
    bool timeStepperActivate(bool);
    boost::shared_ptr<Engine> engineByName(const std::string&);
};

}
