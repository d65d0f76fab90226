// The three ways in which a stiffness may be given, and springs in series.
#pragma once

namespace grus::physics {

enum class StiffnessKind {
    Total,   ///< of the whole bond section [N/m]
    PerArea, ///< of the bond section, per unit area [Pa/m]
    Modulus, ///< of the bond material [Pa]: per area it is E / (RA + RB)
};

/// Stiffness of the whole section [N/m] from `value` given as `kind`; `area` [m2], `length` = RA + RB [m].
inline double sectionStiffness(StiffnessKind kind, double value, double area, double length) {
    switch (kind) {
    case StiffnessKind::Total:
        return value;
    case StiffnessKind::PerArea:
        return value * area;
    case StiffnessKind::Modulus:
        return value / length * area;
    }
    return value;
}

/// Two springs in series (Manso et al. 2015, eqs 1 and 2); 0 when both are 0.
inline double inSeries(double a, double b) { return a + b > 0 ? a * b / (a + b) : 0; }

}
