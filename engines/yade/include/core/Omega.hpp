#pragma once

#include <map>
#include <set>
#include <string>

#include <boost/shared_ptr.hpp>

#include <lib/base/Singleton.hpp>

namespace yade {

class Scene;

/// What YADE knows of a class: its bases, and whether archives know it.
struct DynlibDescriptor {
    std::set<std::string> baseClasses;
    bool isSerializable;
};

/// The running YADE. Its members stay YADE's own business.
class Omega : public Singleton<Omega> {
public:
    const std::map<std::string, DynlibDescriptor>& getDynlibsDescriptor() const;
    bool isInheritingFrom_recursive(const std::string& className, const std::string& baseClassName);
    const boost::shared_ptr<Scene>& getScene() const;
};

}
