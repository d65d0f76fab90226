#include <yade/guard.hpp>

#include <dlfcn.h>
#include <link.h>

#include <core/GlobalEngine.hpp>
#include <core/Omega.hpp>
#include <core/Scene.hpp>
#include <pkg/dem/ScGeom.hpp>
#include <yade/guard_table.hpp>

namespace yade {
namespace sdk {

namespace py = boost::python;

namespace {

using Differences = std::vector<std::string>;

/// The message of the Python exception that is set, which is cleared.
std::string pythonError() {
    PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
    PyErr_Fetch(&type, &value, &trace);
    PyErr_NormalizeException(&type, &value, &trace);
    const py::handle<> owned[] = {py::handle<>(py::allow_null(type)), py::handle<>(py::allow_null(value)),
                                  py::handle<>(py::allow_null(trace))};
    return py::extract<std::string>(py::str(py::object(owned[1])));
}

std::string dotted(const py::object& version) { // major.minor of (1, 74, 0)
    return py::extract<std::string>(
        py::str(".").join(py::make_tuple(py::str(py::object(version[0])), py::str(py::object(version[1])))));
}

void compareVersions(const std::map<std::string, std::string>& versions, Differences& differences) {
    const py::object yade = py::import("yade");
    const std::map<std::string, std::string> found = {
        {"version", py::extract<std::string>(yade.attr("config").attr("version"))},
        {"boost", dotted(py::import("yade.libVersions").attr("getVersion")("boost"))},
        {"python", dotted(py::import("sys").attr("version_info"))}};
    for (const auto& [what, wanted] : versions)
        if (found.at(what) != wanted)
            differences.push_back((what == "version" ? "YADE" : what) + " " + found.at(what) + " instead of " + wanted);
}

/// Virtual functions more or fewer than declared would make every call land beside its aim.
void compareVtables(const std::vector<Vtable>& vtables, Differences& differences) {
    for (const auto& table : vtables) {
        void* const address = dlsym(RTLD_DEFAULT, table.symbol);
        void* found = nullptr;
        Dl_info info;
        const bool known = address && dladdr1(address, &info, &found, RTLD_DL_SYMENT) && found;
        const auto* const symbol = static_cast<const ElfW(Sym)*>(found);
        if (!known)
            differences.push_back(std::string("no table of virtual functions of ") + table.className);
        else if (symbol->st_size != table.bytes)
            differences.push_back(std::string("virtual functions of ") + table.className + " take " +
                                  std::to_string(symbol->st_size) + " bytes, not " + std::to_string(table.bytes));
    }
}

void compareMember(const Probe& probe, Differences& differences) {
    const std::string name = std::string(probe.className) + "." + probe.member;
    try {
        const py::object object = py::import("yade.wrapper").attr(probe.className)();
        char* const start = reinterpret_cast<char*>(&py::extract<Serializable&>(object)());
        if (!probe.agrees(object, probe.member, start + probe.offset))
            differences.push_back(name + " is not at byte " + std::to_string(probe.offset));
    } catch (const py::error_already_set&) {
        differences.push_back(name + ": " + pythonError());
    }
}

/// What Python cannot set and read back: references, and the parts of the current scene.
void compareScene(Differences& differences) {
    const auto need = [&](bool fine, const char* what) {
        if (!fine)
            differences.push_back(what);
    };
    const State state;
    need(&state.pos == &state.se3.position && &state.ori == &state.se3.orientation, "State.pos does not refer to se3");
    ScGeom geom;
    need(&geom.radius1 == &geom.refR1 && &geom.radius2 == &geom.refR2, "ScGeom.radius1 does not refer to refR1");

    Scene& scene = *Omega::instance().getScene();
    const py::object omega = py::import("yade.wrapper").attr("Omega")();
    need(GlobalEngine().scene == &scene, "Engine.scene is not the current scene");
    need(scene.dt == py::extract<Real>(omega.attr("dt"))() && scene.iter == py::extract<long>(omega.attr("iter"))(),
         "Scene.dt or Scene.iter differs from Python's");
    need(scene.forces.nThreads == scene.forces.getNumAllocatedThreads(), "Scene.forces is not where it should be");
    need(scene.bodies->body.size() == scene.bodies->size(), "Scene.bodies does not hold its bodies");
    need(scene.interactions->currSize == scene.interactions->linIntrs.size() &&
             scene.interactions->bodies == &scene.bodies->body,
         "Scene.interactions is not attached to Scene.bodies");
}

}

py::list check(py::dict expected) {
    GuardTable table = generatedTable();
    const py::list keys = expected.keys();
    for (py::ssize_t i = 0; i < py::len(keys); ++i)
        table.replace(py::extract<std::string>(keys[i]), expected[keys[i]]);

    Differences differences;
    compareVersions(table.versions, differences);
    if (differences.empty())
        compareVtables(table.vtables, differences);
    if (differences.empty())
        for (const auto& probe : table.probes)
            compareMember(probe, differences);
    if (differences.empty())
        compareScene(differences);
    py::list result;
    for (const auto& text : differences)
        result.append(text);
    return result;
}

}
}
