#pragma once

#include <sdk/python.hpp>

namespace yade {
namespace sdk {

/// Compares the loaded YADE with the layout table that this module was compiled with and returns the differences, one
/// string each; empty when the module may be used. Changes nothing in YADE; its current scene is only read.
///
/// expected replaces entries of the table: "version", "boost", "python" (strings), "Class" (size of its table of
/// virtual functions in bytes) or "Class.member" (position in bytes). Raises KeyError for other keys.
__attribute__((visibility("hidden"))) boost::python::list check(boost::python::dict expected);

}
}
