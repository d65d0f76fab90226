#include <grainloop/Elements.hpp>

namespace grus::grainloop {

void Elements::resize(std::size_t n) {
    for (Vectors* v : {&position, &velocity, &rate})
        v->resize(n);
    radius.resize(n);
    for (auto* v : {&body, &kind, &mask})
        v->resize(n);
}

void Bodies::resize(std::size_t n) {
    for (Vectors* v : {&position, &velocity, &rate, &momentum, &inertia, &free, &freeTurn})
        v->resize(n);
    for (auto* v : {&qw, &qx, &qy, &qz, &mass, &damped, &reach})
        v->resize(n);
}

}
