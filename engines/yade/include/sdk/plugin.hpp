#pragma once

#include <string>
#include <vector>

#include <boost/preprocessor/cat.hpp>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/shared_ptr.hpp>

#include <lib/factory/Factorable.hpp>

namespace yade {
namespace sdk {

/// How YADE's factory makes an object of a class of this module.
struct PluginClass {
    std::string name;
    Factorable* (*create)();
    boost::shared_ptr<Factorable> (*createShared)();
    void* (*createPureCustom)();
};

/// Classes of this module. Hidden, because with YADE's global symbol scope two modules would share one list otherwise.
__attribute__((visibility("hidden"))) std::vector<PluginClass>& pluginClasses();

template <class Class> bool addPluginClass(const char* name) {
    pluginClasses().push_back({name, []() -> Factorable* { return new Class; },
                               [] { return boost::shared_ptr<Factorable>(new Class); },
                               []() -> void* { return new Class; }});
    return true;
}

}
}

#define YADE_SDK_EXPORT_(r, unused, Class) BOOST_CLASS_EXPORT_IMPLEMENT(yade::Class)
#define YADE_SDK_LIST_(r, unused, Class)                                                                               \
    [[maybe_unused]] const bool BOOST_PP_CAT(listed, Class) =                                                          \
        ::yade::sdk::addPluginClass<Class>(BOOST_PP_STRINGIZE(Class));

/// Once per class, in namespace yade of its source file: YADE_PLUGIN((One)(Other));
#define YADE_PLUGIN(classes)                                                                                           \
    }                                                                                                                  \
    BOOST_PP_SEQ_FOR_EACH(YADE_SDK_EXPORT_, ~, classes)                                                                \
    namespace yade {                                                                                                   \
    namespace {                                                                                                        \
    BOOST_PP_SEQ_FOR_EACH(YADE_SDK_LIST_, ~, classes)                                                                  \
    }
