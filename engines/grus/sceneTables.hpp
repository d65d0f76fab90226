#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <lib/base/Math.hpp>

namespace yade {

/// Contacts of a scene that carry BondPhys, as one list a column, sorted by ids.
struct ContactTable {
    std::vector<std::array<std::int32_t, 2>> ids; ///< smaller id first
    std::vector<std::uint8_t> bonded;             ///< 1 while the bond holds
    std::vector<std::uint8_t> breakage;           ///< how it broke: 0 not, 1 in tension, 2 in shear
    std::vector<Real> force;                      ///< normal force of contact and bond, compression positive [N]
    std::vector<Vector3r> point;                  ///< contact point [m]
};

/// Places and motions of some bodies.
struct BodyTable {
    std::vector<Vector3r> position; ///< [m]
    std::vector<Vector3r> velocity; ///< [m/s]
};

/// The contacts of the current scene that are real.
ContactTable contactTable();

/// The bodies with these ids in the current scene, in this order; throws std::invalid_argument for an id without body.
BodyTable bodyTable(const std::vector<int>& ids);

/// Defines contactTable and bodyTable in the Python module that is being made; columns are bytes, for numpy.frombuffer.
void exposeSceneTables();

}
