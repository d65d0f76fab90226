#pragma once

#include <string>
#include <type_traits>

#include <sdk/python.hpp>

#include <lib/base/Math.hpp>

namespace yade {

/// What may be done with an attribute; flags combine with |.
namespace Attr {
enum flags { noSave = 1, readonly = 2, triggerPostLoad = 4, hidden = 8 };
}

namespace sdk {

/// Flags as written in an attribute's tuple, where the place may be empty.
constexpr int attrFlags(int flags = 0) { return flags; }

/// Without a setter (None) Python refuses assignment.
inline void addProperty(boost::python::object& python, const char* name, const boost::python::object& get,
                        const boost::python::object& set, const std::string& doc) {
    using namespace boost::python;
    const object property(handle<>(borrowed(reinterpret_cast<PyObject*>(&PyProperty_Type))));
    setattr(python, name, property(get, set, object(), doc));
}

/// Eigen objects are handed to Python by reference, so that obj.vector[1] = 9 changes the object.
template <class T> struct ByReference : std::is_base_of<Eigen::MatrixBase<T>, T> {};
template <> struct ByReference<Quaternionr> : std::true_type {};

template <class Class, class T, T Class::*member> void setAndLoad(Class& self, const T& value) {
    self.*member = value;
    self.callPostLoad();
}

template <int flags, auto member> struct Attribute;

/// Python's property of one attribute.
template <int flags, class Class, class T, T Class::*member> struct Attribute<flags, member> {
    static void add(boost::python::object& python, const char* name, const std::string& doc, const char* byDefault,
                    const char* type) {
        using namespace boost::python;
        if constexpr ((flags & Attr::hidden) == 0) {
            using Policy = std::conditional_t<ByReference<T>::value, return_internal_reference<>,
                                              return_value_policy<return_by_value>>;
            // The roles are those that YADE's manual is made from.
            const std::string roles = std::string(" :ydefault:`") + byDefault + "` :yattrtype:`" + type +
                                      "` :yattrflags:`" + std::to_string(flags) + "` ";
            addProperty(python, name, make_getter(member, Policy()), setter(), doc + roles);
        }
    }

    static boost::python::object setter() {
        using namespace boost::python;
        if constexpr ((flags & Attr::readonly) != 0)
            return object();
        else if constexpr ((flags & Attr::triggerPostLoad) != 0)
            return make_function(&setAndLoad<Class, T, member>);
        else
            return make_setter(member);
    }

    static bool set(Class& self, const char* name, const std::string& key, const boost::python::object& value) {
        if constexpr ((flags & Attr::hidden) != 0)
            return false;
        if (key != name)
            return false;
        self.*member = boost::python::extract<T>(value)();
        return true;
    }

    static void get(const Class& self, const char* name, boost::python::dict& into) {
        if constexpr ((flags & Attr::hidden) == 0)
            into[name] = boost::python::object(self.*member);
    }

    template <class Archive> static void archive(Archive& archive, Class& self, const char* name) {
        if constexpr ((flags & Attr::noSave) == 0)
            archive& boost::serialization::make_nvp(name, self.*member);
    }
};

}
}
