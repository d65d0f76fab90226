// Vectors as structures of arrays.
#pragma once

#include <cstddef>
#include <grainloop/Array.hpp>

#include <physics/vector.hpp>

namespace grus::grainloop {

using physics::Vec3;

/// n vectors, one array a component.
struct Vectors {
    Array<double> x, y, z;

    void resize(std::size_t n) {
        x.resize(n);
        y.resize(n);
        z.resize(n);
    }
    std::size_t size() const { return x.size(); }
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vec3& v) {
        x[i] = v.x();
        y[i] = v.y();
        z[i] = v.z();
    }
};

/// Pointers to the three components, for the inner loops.
template <class T> struct Components { T* __restrict__ x, * __restrict__ y, * __restrict__ z; };

inline Components<double> components(Vectors& v) { return {v.x.data(), v.y.data(), v.z.data()}; }
inline Components<const double> components(const Vectors& v) { return {v.x.data(), v.y.data(), v.z.data()}; }

/// A polar vector (position, velocity, force): in the plane its third component is zero, and the compiler knows it.
template <int dim, class T> inline Vec3 polar(const Components<T>& v, std::size_t i) {
    return {v.x[i], v.y[i], dim == 3 ? v.z[i] : 0.0};
}

/// An axial vector (rotation, moment): in the plane only its third component is not zero.
template <int dim, class T> inline Vec3 axial(const Components<T>& v, std::size_t i) {
    return {dim == 3 ? v.x[i] : 0.0, dim == 3 ? v.y[i] : 0.0, v.z[i]};
}

template <int dim> inline void setPolar(const Components<double>& v, std::size_t i, const Vec3& a) {
    v.x[i] = a.x();
    v.y[i] = a.y();
    if (dim == 3)
        v.z[i] = a.z();
}

template <int dim> inline void setAxial(const Components<double>& v, std::size_t i, const Vec3& a) {
    if (dim == 3) {
        v.x[i] = a.x();
        v.y[i] = a.y();
    }
    v.z[i] = a.z();
}

}
