// The load guard of a module that was compiled with the headers of the YADE it runs in (GRUS_YADE_SOURCE).

#include <yade/guard.hpp>

namespace yade {
namespace sdk {

boost::python::list check(boost::python::dict) { return boost::python::list(); } // nothing was assumed

}
}
