#pragma once

// What is declared differently for the YADEs that Grus can be built for; everything else is the same in all of them.
// YADE_HOST is 202302 for YADE 2023.02a, 202502 for 2025.2.0.

#include <vector>

#if YADE_HOST < 202502
#define YADE_HOST_CLUMP_IDS std::vector<int> ids;
#else
#define YADE_HOST_CLUMP_IDS // computed from the members where it is asked for
#endif
