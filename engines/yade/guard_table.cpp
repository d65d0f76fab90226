#include <yade/guard_table.hpp>

#include <layout_probes.hpp>

namespace yade {
namespace sdk {

using boost::python::extract;

GuardTable generatedTable() {
    return {
        {{"version", layoutVersion}, {"boost", layoutBoost}, {"python", layoutPython}}, layoutVtables, layoutProbes};
}

void GuardTable::replace(const std::string& key, const boost::python::object& value) {
    bool known = versions.count(key);
    if (known)
        versions[key] = extract<std::string>(value);
    for (auto& vtable : vtables) {
        if (key != vtable.className)
            continue;
        vtable.bytes = extract<std::size_t>(value);
        known = true;
    }
    for (auto& probe : probes) {
        if (key != std::string(probe.className) + "." + probe.member)
            continue;
        probe.offset = extract<std::size_t>(value);
        known = probe.offset + probe.size <= probe.classSize;
    }
    if (known)
        return;
    PyErr_SetString(PyExc_KeyError, ("no entry, or no place in the object: " + key).c_str());
    boost::python::throw_error_already_set();
}

}
}
