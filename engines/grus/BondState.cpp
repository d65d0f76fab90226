#include <grus/BondState.hpp>

namespace yade {

YADE_PLUGIN((BondState));

}
