#pragma once

#include <core/Dispatching.hpp>
