#pragma once

#include <lib/base/openmp-accu.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

/// O.energy: named sums [J]. Look at scene->trackEnergy first; create an entry (findId) outside parallel regions.
class EnergyTracker : public Serializable {
public:
    OpenMPArrayAccumulator<Real> energies;
    std::map<std::string, int> names;
    std::vector<bool> resetStep;

    EnergyTracker();
    YADE_HOST_CLASS(EnergyTracker)
    /// index is kept by the caller, starts at -1 and is filled in.
    void findId(const std::string& name, int& index, bool reset = false, bool newIfNotFound = true);
    void add(const Real& value, const std::string& name, int& index, bool reset = false);
    Real getItem_py(const std::string& name);
    Real total() const;
};

}
