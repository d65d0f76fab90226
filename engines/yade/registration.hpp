#pragma once

#include <sdk/python.hpp>

namespace yade {
namespace sdk {

/// Makes this module's classes known to YADE's factory, to Python (yade.wrapper) and to YADE's table of base classes,
/// and returns their names, bases first. Later calls only return the names.
/// Throws std::runtime_error when YADE already has a class of one of the names.
__attribute__((visibility("hidden"))) boost::python::list registerClasses();

}
}
