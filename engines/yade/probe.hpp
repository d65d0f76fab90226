#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <sdk/python.hpp>

#include <core/IGeom.hpp>
#include <core/IPhys.hpp>
#include <core/Bound.hpp>
#include <core/Material.hpp>
#include <core/Shape.hpp>
#include <core/State.hpp>
#include <lib/base/Math.hpp>

namespace yade {
namespace sdk {

/// A member that Python can see and where the layout table has it.
struct Probe {
    const char* className;
    const char* member;
    std::size_t offset;
    std::size_t classSize;
    std::size_t size;
    /// True when a value set in Python appears at the place, and a value put there appears in Python.
    bool (*agrees)(boost::python::object, const char* member, char* place);
};

/// Two different values that no fresh object has.
template <class T> T sample(int which) { return T(7341 + 1786 * which); }
template <> inline bool sample(int which) { return which == 0; }
template <> inline std::string sample(int which) { return which == 0 ? "probe_a" : "probe_b"; }
template <> inline std::vector<int> sample(int which) { return {31 + which, 57, 93 - which}; }
template <> inline Vector3r sample(int which) { return Vector3r(1.5, -2.25, 3.125 + which); }
template <> inline Vector3i sample(int which) { return Vector3i(31, -57, 93 + which); }
template <> inline Quaternionr sample(int which) { return Quaternionr(.5, .5, which == 0 ? -.5 : .5, .5); }
template <> inline Matrix3r sample(int which) {
    Matrix3r matrix;
    matrix << 2, .25, .125, .5, 3, .0625, .75, .375, 4 + which;
    return matrix;
}

/// Python makes the object; the roots of the kinds are classes there like any other.
template <class Kind> boost::shared_ptr<Kind> made(const char* name) {
    const boost::python::object python = boost::python::import("yade.wrapper").attr(name)();
    return boost::python::extract<const boost::shared_ptr<Kind>&>(python)();
}
template <> inline boost::shared_ptr<Bound> sample(int) { return made<Bound>("Bound"); }
template <> inline boost::shared_ptr<IGeom> sample(int) { return made<IGeom>("IGeom"); }
template <> inline boost::shared_ptr<IPhys> sample(int) { return made<IPhys>("IPhys"); }
template <> inline boost::shared_ptr<Material> sample(int) { return made<Material>("Material"); }
template <> inline boost::shared_ptr<Shape> sample(int) { return made<Shape>("Shape"); }
template <> inline boost::shared_ptr<State> sample(int) { return made<State>("State"); }

/// Whether the bytes at a place can be the value; looks at bytes only, because a wrong place may hold anything.
template <class T> bool holds(const char* place, const T& value) { return std::memcmp(place, &value, sizeof(T)) == 0; }
template <class Kind> bool holds(const char* place, const boost::shared_ptr<Kind>& value) {
    const Kind* held = value.get(); // the count behind it differs: Python wraps each pointer anew
    return std::memcmp(place, &held, sizeof held) == 0;
}
inline bool holds(const char* place, const std::string& value) {
    const char* text; // a short string points to its own bytes
    std::memcpy(&text, place, sizeof text);
    return text == place + 16 && std::memcmp(text, value.c_str(), value.size() + 1) == 0;
}
inline bool holds(const char* place, const std::vector<int>& value) {
    const int* ends[2];
    std::memcpy(ends, place, sizeof ends);
    return reinterpret_cast<const char*>(ends[1]) - reinterpret_cast<const char*>(ends[0]) ==
               static_cast<std::ptrdiff_t>(value.size() * sizeof(int)) &&
           std::memcmp(ends[0], value.data(), value.size() * sizeof(int)) == 0;
}

/// Whether Python sees the value.
template <class T> bool shows(const boost::python::object& python, const T& value) {
    return boost::python::extract<T>(python)() == value;
}
inline bool shows(const boost::python::object& python, const Quaternionr& value) {
    return boost::python::extract<Quaternionr>(python)().coeffs() == value.coeffs();
}
template <class Kind> bool shows(const boost::python::object& python, const boost::shared_ptr<Kind>& value) {
    return boost::python::extract<Kind*>(python)() == value.get();
}

template <class T> bool agrees(boost::python::object python, const char* member, char* place) {
    using namespace boost::python;
    const T fromPython = sample<T>(0);
    dict keywords;
    keywords[member] = fromPython;
    python.attr("updateAttrs")(keywords);
    if (!holds(place, fromPython))
        return false;
    const T fromHere = sample<T>(1);
    *reinterpret_cast<T*>(place) = fromHere;
    return shows(object(python.attr("dict")()[member]), fromHere);
}

}
}
