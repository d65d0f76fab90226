// Servo of a loading platen.
#pragma once

#include <algorithm>

namespace grus::physics {

/// Speed [m/s] at which a platen moves to bring `error` = target - measured force [N] to zero: the share `relaxation`
/// of the error is removed in one step against the contact stiffness [N/m] of the platen, never faster than `cap`.
/// Without contact the platen closes (or opens) at the cap.
inline double servoSpeed(double error, double stiffness, double dt, double relaxation, double cap) {
    if (stiffness <= 0)
        return error > 0 ? cap : error < 0 ? -cap : 0;
    return std::clamp(relaxation * error / (stiffness * dt), -cap, cap);
}

}
