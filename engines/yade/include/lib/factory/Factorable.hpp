#pragma once

#include <string>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>

namespace yade {

/// Root of everything that can be created by name.
class Factorable : public boost::enable_shared_from_this<Factorable> {
public:
    Factorable() {}
    virtual ~Factorable();
    virtual std::string getBaseClassName(unsigned i = 0) const;
    virtual int getBaseClassNumber() const;
    virtual std::string getClassName() const;
};

}
