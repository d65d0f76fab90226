#include <yade/registration.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <typeinfo>

#include <core/Omega.hpp>
#include <lib/factory/ClassFactory.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {
namespace sdk {

std::vector<PluginClass>& pluginClasses() {
    static std::vector<PluginClass> classes;
    return classes;
}

namespace {

std::string baseOf(const PluginClass& known) { return known.createShared()->getBaseClassName(0); }

/// Python refuses a class whose base it does not know, and source files register in any order.
std::vector<PluginClass> basesFirst(std::vector<PluginClass> waiting) {
    std::set<std::string> names;
    for (const auto& entry : waiting)
        names.insert(entry.name);
    std::vector<PluginClass> sorted;
    while (!waiting.empty()) {
        const auto next =
            std::find_if(waiting.begin(), waiting.end(), [&](const auto& it) { return !names.count(baseOf(it)); });
        if (next == waiting.end())
            throw std::logic_error("classes are bases of each other: " + waiting[0].name);
        names.erase(next->name);
        sorted.push_back(*next);
        waiting.erase(next);
    }
    return sorted;
}

void enterFactory(const PluginClass& entry) {
    auto& factory = ClassFactory::instance();
    if (factory.registerFactorable(entry.name, entry.create, entry.createShared, entry.createPureCustom))
        return;
    // The name is taken; headers of a real YADE source tree have entered this same class by themselves.
    const auto taken = factory.createShared(entry.name), ours = entry.createShared();
    if (typeid(*taken) != typeid(*ours))
        throw std::runtime_error("YADE already has a class named " + entry.name);
}

/// YADE fills this table once, at its start, and gives out read access only.
void enterBaseTable(const PluginClass& entry) {
    auto& table = const_cast<std::map<std::string, DynlibDescriptor>&>(Omega::instance().getDynlibsDescriptor());
    table[entry.name] = {{baseOf(entry)}, true};
}

void enterPython(const PluginClass& entry) {
    boost::dynamic_pointer_cast<Serializable>(entry.createShared())
        ->pyRegisterClass(boost::python::import("yade.wrapper"));
}

}

boost::python::list registerClasses() {
    static bool done = false;
    boost::python::list names;
    for (const auto& entry : basesFirst(pluginClasses())) {
        if (!done) {
            enterFactory(entry);
            enterBaseTable(entry);
            enterPython(entry);
        }
        names.append(entry.name);
    }
    done = true;
    return names;
}

}
}
