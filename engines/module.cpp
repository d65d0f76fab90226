// The Python module grus._engines. Importing it registers nothing: grus.host.load first calls check(), and register()
// only when that finds no difference to the YADE at hand.

#include <grus/insertSpecimen.hpp>
#include <grus/sceneTables.hpp>
#include <yade/guard.hpp>
#include <yade/registration.hpp>

BOOST_PYTHON_MODULE(_engines) {
    boost::python::def(
        "check", &yade::sdk::check,
        "Differences between the loaded YADE and the layout that this module was compiled for; empty when "
        "it may be used. The argument replaces entries of the table, by name.");
    boost::python::def("register", &yade::sdk::registerClasses,
                       "Makes Grus's classes known to YADE; returns their names, bases first. Call check() before.");
    yade::exposeInsertSpecimen();
    yade::exposeSceneTables();
}
