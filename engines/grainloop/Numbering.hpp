// Numbers equal rows of numbers equally.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace grus::grainloop {

template <std::size_t width> class Numbering {
public:
    using Row = std::array<double, width>;

    /// Number of `row`, in the order in which new ones came, and whether it is new.
    std::pair<int, bool> number(const Row& row) {
        if (last && row == last->first) // neighbours are mostly alike
            return {last->second, false};
        const auto [found, isNew] = numbers.try_emplace(row, static_cast<int>(numbers.size()));
        last = &*found;
        return {found->second, isNew};
    }
    void clear() {
        numbers.clear();
        last = nullptr;
    }

private:
    struct Hash {
        std::size_t operator()(const Row& row) const {
            std::uint64_t sum = 0;
            for (const double value : row) {
                std::uint64_t bits;
                const double positive = value + 0.0; // of -0
                std::memcpy(&bits, &positive, sizeof bits);
                sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
                sum ^= sum >> 32;
            }
            return sum;
        }
    };
    std::unordered_map<Row, int, Hash> numbers;
    const std::pair<const Row, int>* last = nullptr; // entries stay where they are
};

}
