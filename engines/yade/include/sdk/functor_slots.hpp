#pragma once

#include <string>
#include <type_traits>

namespace yade {
namespace sdk {

/// Start of a functor's second table of virtual functions.
class FunctorHead {
public:
    virtual ~FunctorHead() {}
    /// "Type1 Type2" for geometry functors; empty for the others.
    virtual std::string checkOrder() const { return ""; }

protected:
    void unused() {} // the name that the entries below share
};

/// Count entries that YADE never calls: its overloads with fewer or more parameters than the functor takes.
template <class Below, class Tag, int count> class Unused : public Unused<Below, Tag, count - 1> {
protected:
    using Unused<Below, Tag, count - 1>::unused;
    virtual void unused(std::integral_constant<int, count>, Tag) {}
};
template <class Below, class Tag> class Unused<Below, Tag, 0> : public Below {};

struct BeforeGo {};
struct AfterGo {};
struct BeforeReverse {};
struct AfterReverse {};

template <class Return, class... Parameters>
class GoSlot : public Unused<FunctorHead, BeforeGo, int(sizeof...(Parameters)) - 1> {
public:
    virtual Return go(Parameters...) { return Return(); }
};

template <class Return, class... Parameters>
class ReverseSlot : public Unused<Unused<GoSlot<Return, Parameters...>, AfterGo, 7 - int(sizeof...(Parameters))>,
                                  BeforeReverse, int(sizeof...(Parameters)) - 1> {
public:
    virtual Return goReverse(Parameters...) { return Return(); }
};

/// YADE's table has go() and goReverse() with one to seven parameters each, in this order.
template <class Return, class... Parameters>
class FunctorSlots : public Unused<ReverseSlot<Return, Parameters...>, AfterReverse, 7 - int(sizeof...(Parameters))> {};

}
}
