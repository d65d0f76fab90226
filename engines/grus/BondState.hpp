#pragma once

#include <core/State.hpp>

namespace yade {

/// State of an element that remembers which grain it was born in.
class BondState : public State {
public:
    virtual ~BondState(){};

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR(BondState, State,
        "State of an element of :yref:`BondMat`: which grain it belongs to.",
        ((int, grain, -1, , "Number of the grain that the element was born in; -1: of none (a platen, a loose element), which is never bonded."))
        ((int, element, -1, , "Number of the element within its grain, by which the strengths of its bonds are drawn; -1: the body's id is used."))
        ((Real, grainDiameter, 0, , "Diameter of that grain [m], for the size effect of strength."))
        , createIndex();
    );
    // clang-format on
    REGISTER_CLASS_INDEX(BondState, State);
};
REGISTER_SERIALIZABLE(BondState);

}
