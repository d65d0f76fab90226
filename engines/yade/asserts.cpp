// Holds the headers to the table of YADE's layout while compiling; there is nothing here at run time.

#include <cstddef>

#include <core/Dispatching.hpp>
#include <core/Clump.hpp>
#include <core/Omega.hpp>
#include <core/PartialEngine.hpp>
#include <core/Scene.hpp>
#include <core/TimeStepper.hpp>
#include <pkg/common/Aabb.hpp>
#include <pkg/common/BoundaryController.hpp>
#include <pkg/common/Box.hpp>
#include <pkg/common/ElastMat.hpp>
#include <pkg/common/Facet.hpp>
#include <pkg/common/PeriodicEngines.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/common/Wall.hpp>
#include <pkg/dem/FrictPhys.hpp>
#include <pkg/dem/ScGeom.hpp>

// YADE's classes are not of standard layout, for which C++ only conditionally supports offsetof; GCC and Clang do.
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#include <layout_asserts.hpp>
