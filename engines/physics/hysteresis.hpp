// Contact whose asperities yield (Walton & Braun 1986): loading along kn, unloading and reloading along ratio kn until
// the largest overlap so far is reached again.
#pragma once

#include <algorithm>

namespace grus::physics {

/// What does not change while a contact lives.
struct Hysteresis {
    double stiffness = 0;    ///< of unloading, ratio kn [N/m]
    double plasticShare = 0; ///< share of the largest overlap that stays without force, 1 - 1 / ratio [-]
};

inline Hysteresis hysteresis(double kn, double ratio) { return {ratio * kn, 1 - 1 / ratio}; }

/// Normal force [N] at `overlap` [m], never tension; `largest` overlap so far [m], this one included.
inline double hystereticNormal(const Hysteresis& h, double overlap, double largest) {
    return std::max(0.0, h.stiffness * (overlap - h.plasticShare * largest));
}

}
