// Cross-section of a parallel bond (Potyondy & Cundall 2004).
#pragma once

namespace grus::physics {

/// Area [m2], second moment of area about an axis in the section [m4], polar moment [m4] (0 in the plane: no twist).
struct Section {
    double area = 0;
    double inertia = 0;
    double polar = 0;
};

constexpr double pi = 3.14159265358979323846;

/// Round section of radius `r` [m], for spheres.
inline Section roundSection(double r) { return {pi * r * r, pi * r * r * r * r / 4, pi * r * r * r * r / 2}; }

/// Strip of height 2r and depth `thickness` [m], for discs.
inline Section stripSection(double r, double thickness) {
    return {2 * r * thickness, 2.0 / 3.0 * r * r * r * thickness, 0};
}

/// Strip when `thickness` is positive, round otherwise.
inline Section bondSection(double r, double thickness) {
    return thickness > 0 ? stripSection(r, thickness) : roundSection(r);
}

}
