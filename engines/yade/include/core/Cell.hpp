#pragma once

#include <lib/serialization/Serializable.hpp>

namespace yade {

/// The periodic cell; columns of hSize are its edges.
class Cell : public Serializable {
public:
    Matrix3r _invTrsf;
    Matrix3r _trsfInc;
    Matrix3r _vGradTimesPrevH;
    Vector3r _size;
    Vector3r _cos;
    Vector3r _refSize;
    bool _hasShear;
    Matrix3r _shearTrsf;
    Matrix3r _unshearTrsf;
    double _glShearTrsfMatrix[16];
    Matrix3r trsf;
    Matrix3r refHSize;
    Matrix3r hSize;
    Matrix3r prevHSize;
    Matrix3r velGrad;
    Matrix3r nextVelGrad;
    Matrix3r prevVelGrad;
    int homoDeform;
    bool velGradChanged;
    bool flipFlippable;

    Cell();
    YADE_HOST_CLASS(Cell)
    const Vector3r& getSize() const { return _size; }
    bool hasShear() const { return _hasShear; }
    Real getVolume() const;
    /// Takes effect when the integrator runs next.
    void setVelGrad(const Matrix3r&);
    /// Shift of the second body's position in an interaction.
    Vector3r intrShiftPos(const Vector3i& cellDist) const { return hSize * cellDist.cast<Real>(); }
    /// Shift of the second body's velocity in an interaction.
    Vector3r intrShiftVel(const Vector3i& cellDist) const { return _vGradTimesPrevH * cellDist.cast<Real>(); }
};

}
