#pragma once

#include <core/Shape.hpp>

namespace yade {

/// A triangle.
class Facet : public Shape {
public:
    Vector3r ne[3];
    Real icr;
    Real vl[3];
    Vector3r vu[3];
    std::vector<Vector3r> vertices; // in the body's axes
    Vector3r normal;
    Real area;

    Facet() : vertices(3, Vector3r::Constant(NaN)), normal(Vector3r::Constant(NaN)), area(NaN) { createIndex(); }
    YADE_HOST_CLASS(Facet)
    YADE_HOST_INDEX(Facet)
    /// Corners in the body's axes; also computes the members that follow from them.
    void setVertices(const Vector3r&, const Vector3r&, const Vector3r&);
};

}
