// A Python module with nothing but the law of the page "How to add a law".

#include <yade/registration.hpp>

BOOST_PYTHON_MODULE(docs_law) { boost::python::def("register", &yade::sdk::registerClasses); }
