#pragma once

#include <stdexcept>
#include <string>

#include <boost/python/raw_function.hpp>

#include <sdk/python.hpp>

namespace yade {
namespace sdk {

/// Makes an object from Python's arguments: positional ones for the class's own hook, keywords for its attributes.
template <class Class>
boost::shared_ptr<Class> construct(boost::python::tuple& positional, boost::python::dict& keywords) {
    boost::shared_ptr<Class> made(new Class);
    made->pyHandleCustomCtorArgs(positional, keywords);
    const auto surplus = boost::python::len(positional);
    if (surplus > 0)
        throw std::runtime_error(made->getClassName() + ": takes keyword arguments only, " + std::to_string(surplus) +
                                 " positional given");
    if (boost::python::len(keywords) > 0) {
        made->pyUpdateAttrs(keywords);
        made->callPostLoad();
    }
    return made;
}

/// Passes self, the other positional arguments as one tuple and the keywords as one dictionary to a constructor.
class KeywordConstructor {
public:
    explicit KeywordConstructor(boost::python::object constructor) : constructor(constructor) {}

    PyObject* operator()(PyObject* args, PyObject* keywords) {
        using namespace boost::python;
        const object all(handle<>(borrowed(args)));
        const dict named = keywords ? dict(handle<>(borrowed(keywords))) : dict();
        return incref(constructor(object(all[0]), tuple(all.slice(1, _)), named).ptr());
    }

private:
    boost::python::object constructor;
};

/// __init__ of a class that is made from keywords.
template <class Class> boost::python::object keywordConstructor() {
    using namespace boost::python;
    const KeywordConstructor call(make_constructor(&construct<Class>));
    return detail::make_raw_function(
        objects::py_function(call, boost::mpl::vector2<void, object>(), 1, std::numeric_limits<unsigned>::max()));
}

}
}
