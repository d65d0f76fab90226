#pragma once

#include <map>
#include <string>
#include <vector>

#include <yade/probe.hpp>

namespace yade {
namespace sdk {

/// A table of virtual functions and its size [bytes].
struct Vtable {
    const char* className;
    const char* symbol;
    std::size_t bytes;
};

/// What the load guard compares YADE with.
struct GuardTable {
    std::map<std::string, std::string> versions; ///< of "version" (YADE), "boost" and "python"
    std::vector<Vtable> vtables;
    std::vector<Probe> probes;

    /// Changes one entry; see check() in guard.hpp for the keys. Raises KeyError in Python.
    void replace(const std::string& key, const boost::python::object& value);
};

/// The table that was generated from the layout file.
GuardTable generatedTable();

}
}
