#pragma once

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/tuple/elem.hpp>

// YADE's class macros, for use inside a class body. An attribute is a tuple (type, name, default, flags, "doc");
// default and flags may be empty. Attributes form a sequence ((...))((...)), which may be empty as well.

#define YADE_SDK_TYPE_(attr) BOOST_PP_TUPLE_ELEM(5, 0, attr)
#define YADE_SDK_NAME_(attr) BOOST_PP_TUPLE_ELEM(5, 1, attr)
#define YADE_SDK_DEFAULT_(attr) BOOST_PP_TUPLE_ELEM(5, 2, attr)
#define YADE_SDK_FLAGS_(attr) ::yade::sdk::attrFlags(BOOST_PP_TUPLE_ELEM(5, 3, attr))
#define YADE_SDK_DOC_(attr) BOOST_PP_TUPLE_ELEM(5, 4, attr)
#define YADE_SDK_KEY_(attr) BOOST_PP_STRINGIZE(YADE_SDK_NAME_(attr))
#define YADE_SDK_TYPE_TEXT_(attr) BOOST_PP_STRINGIZE(YADE_SDK_TYPE_(attr))
#define YADE_SDK_DEFAULT_TEXT_(attr) BOOST_PP_STRINGIZE(YADE_SDK_DEFAULT_(attr))
#define YADE_SDK_ATTRIBUTE_(Class, attr) ::yade::sdk::Attribute<YADE_SDK_FLAGS_(attr), &Class::YADE_SDK_NAME_(attr)>

#define YADE_SDK_DECLARE_(r, Class, attr) YADE_SDK_TYPE_(attr) YADE_SDK_NAME_(attr);
#define YADE_SDK_START_(r, Class, attr) , YADE_SDK_NAME_(attr)(YADE_SDK_DEFAULT_(attr))
#define YADE_SDK_INIT_(r, Class, init) , BOOST_PP_TUPLE_ELEM(2, 0, init)(BOOST_PP_TUPLE_ELEM(2, 1, init))
#define YADE_SDK_SET_(r, Class, attr)                                                                                  \
    if (YADE_SDK_ATTRIBUTE_(Class, attr)::set(*this, YADE_SDK_KEY_(attr), key, value))                                 \
        return;
#define YADE_SDK_GET_(r, Class, attr) YADE_SDK_ATTRIBUTE_(Class, attr)::get(*this, YADE_SDK_KEY_(attr), all);
#define YADE_SDK_ARCHIVE_(r, Class, attr)                                                                              \
    YADE_SDK_ATTRIBUTE_(Class, attr)::archive(archive, *this, YADE_SDK_KEY_(attr));
#define YADE_SDK_PROPERTY_(r, Class, attr)                                                                             \
    YADE_SDK_ATTRIBUTE_(Class, attr)::add(python, YADE_SDK_KEY_(attr), YADE_SDK_DOC_(attr),                            \
                                          YADE_SDK_DEFAULT_TEXT_(attr), YADE_SDK_TYPE_TEXT_(attr));

/// inits: further initialisers ((member, value))...; ctor: statements of the constructor; py: calls on the Python
/// class such as .def("name", &Class::function).
#define YADE_CLASS_BASE_DOC_ATTRS_INIT_CTOR_PY(Class, Base, doc, attrs, inits, ctor, py)                               \
public:                                                                                                                \
    BOOST_PP_SEQ_FOR_EACH(YADE_SDK_DECLARE_, Class, attrs)                                                             \
    Class()                                                                                                            \
        : Base() BOOST_PP_SEQ_FOR_EACH(YADE_SDK_START_, Class, attrs)                                                  \
              BOOST_PP_SEQ_FOR_EACH(YADE_SDK_INIT_, Class, inits) {                                                    \
        ctor;                                                                                                          \
    }                                                                                                                  \
    std::string getClassName() const override { return #Class; }                                                       \
    std::string getBaseClassName(unsigned i = 0) const override { return i == 0 ? #Base : ""; }                        \
    int getBaseClassNumber() const override { return 1; }                                                              \
    void pySetAttr([[maybe_unused]] const std::string& key, const boost::python::object& value) override {             \
        BOOST_PP_SEQ_FOR_EACH(YADE_SDK_SET_, Class, attrs)                                                             \
        Base::pySetAttr(key, value);                                                                                   \
    }                                                                                                                  \
    boost::python::dict pyDict() const override {                                                                      \
        boost::python::dict all;                                                                                       \
        BOOST_PP_SEQ_FOR_EACH(YADE_SDK_GET_, Class, attrs)                                                             \
        all.update(pyDictCustom());                                                                                    \
        all.update(Base::pyDict());                                                                                    \
        return all;                                                                                                    \
    }                                                                                                                  \
    void callPostLoad() override {                                                                                     \
        Base::callPostLoad();                                                                                          \
        postLoad(*this);                                                                                               \
    }                                                                                                                  \
    void pyRegisterClass(boost::python::object scope) override {                                                       \
        checkPyClassRegistersItself(#Class);                                                                           \
        const boost::python::scope into(scope);                                                                        \
        const boost::python::docstring_options docstrings(true, true, false);                                          \
        boost::python::class_<Class, boost::shared_ptr<Class>, boost::python::bases<Base>, boost::noncopyable> python( \
            #Class, doc, boost::python::no_init);                                                                      \
        python.def("__init__", ::yade::sdk::keywordConstructor<Class>());                                              \
        BOOST_PP_SEQ_FOR_EACH(YADE_SDK_PROPERTY_, Class, attrs)                                                        \
        (void)python py;                                                                                               \
    }                                                                                                                  \
    template <class Archive> void serialize(Archive& archive, const unsigned int) {                                    \
        archive& boost::serialization::make_nvp(#Base, boost::serialization::base_object<Base>(*this));                \
        if constexpr (Archive::is_loading::value)                                                                      \
            preLoad(*this);                                                                                            \
        else                                                                                                           \
            preSave(*this);                                                                                            \
        BOOST_PP_SEQ_FOR_EACH(YADE_SDK_ARCHIVE_, Class, attrs)                                                         \
        if constexpr (Archive::is_loading::value)                                                                      \
            postLoad(*this);                                                                                           \
        else                                                                                                           \
            postSave(*this);                                                                                           \
    }

#define YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Class, Base, doc, attrs, ctor, py)                                           \
    YADE_CLASS_BASE_DOC_ATTRS_INIT_CTOR_PY(Class, Base, doc, attrs, , ctor, py)
#define YADE_CLASS_BASE_DOC_ATTRS_CTOR(Class, Base, doc, attrs, ctor)                                                  \
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Class, Base, doc, attrs, ctor, )
#define YADE_CLASS_BASE_DOC_ATTRS(Class, Base, doc, attrs) YADE_CLASS_BASE_DOC_ATTRS_CTOR(Class, Base, doc, attrs, )
#define YADE_CLASS_BASE_DOC(Class, Base, doc) YADE_CLASS_BASE_DOC_ATTRS(Class, Base, doc, )

/// After the class, in namespace yade: the name under which archives know it.
#define REGISTER_SERIALIZABLE(Class)                                                                                   \
    }                                                                                                                  \
    BOOST_CLASS_EXPORT_KEY2(yade::Class, "yade::" #Class)                                                              \
    namespace yade {
