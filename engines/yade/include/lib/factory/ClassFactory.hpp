#pragma once

#include <list>
#include <map>
#include <string>

#include <lib/base/Singleton.hpp>
#include <lib/factory/Factorable.hpp>
#include <sdk/plugin.hpp>

namespace yade {

/// Creates objects by class name; functor dispatch and archives of YADE look classes up here.
class ClassFactory : public Singleton<ClassFactory> {
public:
    virtual ~ClassFactory();
    virtual std::string getClassName() const;
    virtual std::string getBaseClassName(int) const;

    /// False, and without effect, when the name is taken.
    bool registerFactorable(std::string name, Factorable* (*create)(), boost::shared_ptr<Factorable> (*createShared)(),
                            void* (*createPureCustom)());
    boost::shared_ptr<Factorable> createShared(std::string name);
};

}
