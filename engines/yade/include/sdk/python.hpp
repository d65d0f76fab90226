#pragma once

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost.Python's own use of boost/bind.hpp would warn otherwise
#endif

#include <boost/python.hpp>
