#pragma once

#include <sdk/python.hpp>

#include <lib/base/Math.hpp>
#include <lib/factory/Factorable.hpp>
#include <sdk/archive.hpp>
#include <sdk/attribute.hpp>
#include <sdk/class_macros.hpp>
#include <sdk/constructor.hpp>
#include <sdk/declare.hpp>
#include <sdk/plugin.hpp>

namespace yade {

/// Root of everything that Python and archives know.
class Serializable : public Factorable {
public:
    Serializable() {}
    ~Serializable() override;
    std::string getBaseClassName(unsigned i = 0) const override;
    int getBaseClassNumber() const override;
    std::string getClassName() const override;

    virtual void pySetAttr(const std::string& key, const boost::python::object& value);
    virtual boost::python::dict pyDict() const;
    virtual boost::python::dict pyDictCustom() const;
    virtual void callPostLoad();
    virtual void checkPyClassRegistersItself(const std::string& className) const;
    virtual void pyRegisterClass(boost::python::object scope);
    virtual void pyHandleCustomCtorArgs(boost::python::tuple& args, boost::python::dict& keywords);

    void pyUpdateAttrs(const boost::python::dict&);
    std::string pyStr();

    // Hooks around the members in an archive; a class that needs one declares its own, e.g. void postLoad(Class&).
    template <class Class> void preLoad(Class&) {}
    template <class Class> void postLoad(Class&) {}
    template <class Class> void preSave(Class&) {}
    template <class Class> void postSave(Class&) {}

    template <class Archive> void serialize(Archive&, const unsigned int) {}
};

YADE_HOST_KEY(Serializable)

}
