// Memory of the large arrays.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace grus::grainloop {

/// Begins each array at another cache line of a page. A loop goes through some twenty arrays at the same index; at the
/// same place of a page they would drive each other out of the first cache. Large arrays ask for large pages.
template <class T> struct StaggeredMemory {
    using value_type = T;

    StaggeredMemory() = default;
    template <class U> StaggeredMemory(const StaggeredMemory<U>&) {}

    T* allocate(std::size_t n) {
        static constexpr std::size_t large = std::size_t(1) << 21;
        const std::size_t needed = n * sizeof(T) + page, unit = needed >= large / 2 ? large : page;
        const std::size_t size = (needed + unit - 1) / unit * unit;
        void* memory = std::aligned_alloc(unit, size);
        if (!memory)
            throw std::bad_alloc();
        if (unit == large)
            madvise(memory, size, MADV_HUGEPAGE); // a wish; where it is not granted, all works the same
        static std::atomic<unsigned> turn{0};
        return reinterpret_cast<T*>(static_cast<char*>(memory) + turn++ % (page / line) * line);
    }
    void deallocate(T* p, std::size_t) {
        std::free(reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(p) / page * page));
    }
    template <class U> bool operator==(const StaggeredMemory<U>&) const { return true; }
    template <class U> bool operator!=(const StaggeredMemory<U>&) const { return false; }

private:
    static constexpr std::size_t page = 4096, line = 64;
};

template <class T> using Array = std::vector<T, StaggeredMemory<T>>;

}
