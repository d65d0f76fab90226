// Random numbers that depend on nothing but a seed and the ids of the thing they belong to: no state, no visit order.
#pragma once

#include <cstdint>

namespace grus::physics {

/// Purposes keep the draws of one pair of ids apart.
enum class Draw : std::uint64_t { BondStrength = 1, GrainStrength = 2 };

/// Finaliser of the splitmix64 generator (Steele, Lea & Flood 2014).
inline std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// Uniform number in (0, 1), never 0 or 1, from a seed, a purpose and up to three ids. Their order matters: sort them.
inline double uniform(std::uint64_t seed, Draw purpose, std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) {
    const std::uint64_t bits = mix(mix(mix(mix(mix(seed) ^ static_cast<std::uint64_t>(purpose)) ^ a) ^ b) ^ c);
    return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53;
}

}
