#pragma once

// Included before everything else when compiling with the headers of a YADE source tree (GRUS_YADE_SOURCE). Those list
// classes for YADE's own start-up, which is over when Grus is imported; here they go to this module's list instead.
#include <lib/factory/ClassFactory.hpp>
#undef YADE_PLUGIN
#include <sdk/plugin.hpp>
