#include <grainloop/neighbours.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace grus::grainloop {

namespace {

/// Elements sorted into cubes that are no smaller than the longest distance looked for.
class Grid {
public:
    Grid(const Elements& e, double reach) : low(Vec3::Constant(1e300)) {
        Vec3 high = -low;
        for (std::size_t i = 0; i < e.size(); ++i) {
            low = low.cwiseMin(e.position[i]);
            high = high.cwiseMax(e.position[i]);
        }
        // A few elements that flew off must not make the grid larger than the memory.
        for (edge = reach;; edge *= 1.5) {
            double cells = 1;
            for (int c = 0; c < 3; ++c) {
                count[c] = static_cast<int>(std::min((high[c] - low[c]) / edge, 1e6)) + 1;
                cells *= count[c];
            }
            if (cells <= 8.0 * e.size() + 1000)
                break;
        }
        begin.assign(std::size_t(count[0]) * count[1] * count[2] + 1, 0);
        std::vector<int> cell(e.size());
        for (std::size_t i = 0; i < e.size(); ++i)
            ++begin[(cell[i] = index(place(e.position[i]))) + 1];
        for (std::size_t c = 1; c < begin.size(); ++c)
            begin[c] += begin[c - 1];
        member.resize(e.size());
        std::vector<int> next(begin.begin(), begin.end() - 1);
        for (std::size_t i = 0; i < e.size(); ++i)
            member[next[cell[i]]++] = static_cast<int>(i);
    }

    std::array<int, 3> place(const Vec3& x) const {
        std::array<int, 3> p;
        for (int c = 0; c < 3; ++c)
            p[c] = std::min(static_cast<int>((x[c] - low[c]) / edge), count[c] - 1);
        return p;
    }

    /// Calls visit(element) for all elements in the cubes around `x`.
    template <class Visit> void around(const Vec3& x, Visit visit) const {
        const auto p = place(x);
        for (int c = std::max(p[2] - 1, 0); c <= std::min(p[2] + 1, count[2] - 1); ++c)
            for (int b = std::max(p[1] - 1, 0); b <= std::min(p[1] + 1, count[1] - 1); ++b) {
                const int first = index({std::max(p[0] - 1, 0), b, c});
                const int last = index({std::min(p[0] + 1, count[0] - 1), b, c});
                for (int m = begin[first]; m < begin[last + 1]; ++m)
                    visit(member[m]);
            }
    }

private:
    int index(const std::array<int, 3>& p) const { return p[0] + count[0] * (p[1] + count[1] * p[2]); }

    Vec3 low;
    double edge = 0;
    std::array<int, 3> count;
    std::vector<int> begin, member;
};

}

std::vector<std::pair<int, int>> neighbours(const Elements& e, double gap) {
    std::vector<std::pair<int, int>> pairs;
    if (e.size() < 2)
        return pairs;
    const Grid grid(e, 2 * *std::max_element(e.radius.begin(), e.radius.end()) + gap);
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(e.size()); ++i) {
        const Vec3 x = e.position[i];
        found.clear();
        grid.around(x, [&](int j) {
            if (j <= i || e.body[j] == e.body[i] || !(e.mask[i] & e.mask[j]))
                return;
            const double reach = e.radius[i] + e.radius[j] + gap;
            if ((e.position[j] - x).squaredNorm() < reach * reach)
                found.push_back(j);
        });
        std::sort(found.begin(), found.end());
        for (const int j : found)
            pairs.emplace_back(i, j);
    }
    return pairs;
}

}
