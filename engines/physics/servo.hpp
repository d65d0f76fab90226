// Servo of a loading platen.
#pragma once

#include <algorithm>
#include <cmath>

namespace grus::physics {

/// Speed [m/s] at which a platen moves to bring `error` = target - measured force [N] to zero: the share `relaxation`
/// of the error is removed in one step against the contact stiffness [N/m] of the platen, never faster than `cap`.
/// Without contact the platen closes (or opens) at the cap.
inline double servoSpeed(double error, double stiffness, double dt, double relaxation, double cap) {
    if (stiffness <= 0)
        return error > 0 ? cap : error < 0 ? -cap : 0;
    return std::clamp(relaxation * error / (stiffness * dt), -cap, cap);
}

/// Inertial number [-] of a compression at `rate` [1/s] of grains of diameter `d` [m] and density [kg/m3] under the
/// pressure `p` [Pa] (GDR MiDi 2004); quasi-static below about 1e-3.
inline double inertialNumber(double rate, double d, double density, double p) {
    return p > 0 ? std::abs(rate) * d * std::sqrt(density / p) : 0;
}

/// Limits within which a test counts as quasi-static.
struct QuasiStatic {
    double inertialNumber; ///< largest inertial number [-]
    double kineticShare;   ///< largest kinetic over elastic energy [-]
    double stressGradient; ///< largest difference of the stresses on both platens over their mean [-]
};

/// What a test shows at one moment, in the same terms, and the bonds broken since the last look.
struct Calm {
    QuasiStatic found;
    int breaks;
};

/// Next speed limit [m/s]: back to `slow` while bonds break, `growth` times slower while a limit is passed, though not
/// below `slow`, else `growth` times faster up to `fast`. So the limit stays near the speed at which the test is just
/// quasi-static.
inline double nextSpeedLimit(double now, double slow, double fast, double growth, const Calm& calm,
                             const QuasiStatic& limits) {
    const bool quiet = calm.found.inertialNumber <= limits.inertialNumber &&
                       calm.found.kineticShare <= limits.kineticShare &&
                       calm.found.stressGradient <= limits.stressGradient;
    if (calm.breaks > 0)
        return slow;
    return quiet ? std::min(fast, now * growth) : std::max(slow, now / growth);
}

}
