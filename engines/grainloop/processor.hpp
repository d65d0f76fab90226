// One function for several generations of processors, chosen when the program runs.
#pragma once

namespace grus::grainloop {

enum class Processor { Plain, Avx2, Avx512 };

inline Processor processor() {
    static const Processor found = __builtin_cpu_supports("avx512f") ? Processor::Avx512
                                   : __builtin_cpu_supports("avx2")  ? Processor::Avx2
                                                                     : Processor::Plain;
    return found;
}

}

/// Defines `name` with `parameters`, which calls `body` with `arguments`, an always_inline function that is compiled
/// once for each generation. (GCC's target_clones does the same, but does not inline what the body calls.)
#define GRUS_FOR_EACH_PROCESSOR(name, parameters, body, arguments)                                                     \
    __attribute__((target("avx512f"), flatten)) void name##Avx512 parameters { body arguments; }                       \
    __attribute__((target("avx2"), flatten)) void name##Avx2 parameters { body arguments; }                            \
    __attribute__((flatten)) void name##Plain parameters { body arguments; }                                           \
    void name parameters {                                                                                             \
        switch (processor()) {                                                                                         \
        case Processor::Avx512:                                                                                        \
            return name##Avx512 arguments;                                                                             \
        case Processor::Avx2:                                                                                          \
            return name##Avx2 arguments;                                                                               \
        default:                                                                                                       \
            return name##Plain arguments;                                                                              \
        }                                                                                                              \
    }
