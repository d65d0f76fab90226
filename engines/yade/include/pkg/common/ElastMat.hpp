#pragma once

#include <core/Material.hpp>

namespace yade {

/// Elastic material.
class ElastMat : public Material {
public:
    Real young;
    Real poisson;

    ElastMat() : young(1e9), poisson(.25) { createIndex(); }
    YADE_HOST_CLASS(ElastMat)
    YADE_HOST_INDEX(ElastMat)
    YADE_HOST_ARCHIVE(Material, (young)(poisson))
};
YADE_HOST_KEY(ElastMat)

/// Elastic material with friction.
class FrictMat : public ElastMat {
public:
    Real frictionAngle; // [rad]

    FrictMat();
    YADE_HOST_CLASS(FrictMat)
    YADE_HOST_INDEX(FrictMat)
    YADE_HOST_ARCHIVE(ElastMat, (frictionAngle))
};
YADE_HOST_KEY(FrictMat)

}
