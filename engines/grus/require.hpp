#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace yade {

/// Throws std::invalid_argument (Python's ValueError) with one line that names key, value and what is allowed.
template <class Value>
void require(bool condition, const std::string& key, const Value& value, const std::string& allowed) {
    if (condition)
        return;
    std::ostringstream message;
    message << key << " = " << value << "; allowed: " << allowed;
    throw std::invalid_argument(message.str());
}

}
