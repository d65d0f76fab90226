#pragma once

#include <lib/serialization/Serializable.hpp>

#include <sdk/functor_slots.hpp>

namespace yade {

class Scene;
class TimingDeltas;

/// Does one kind of work for one pair of classes (or one class) inside a dispatcher.
class Functor : public Serializable {
public:
    boost::shared_ptr<TimingDeltas> timingDeltas;
    Scene* scene; // set by the loop at each step, not before
    std::string label;

    Functor() {}
    YADE_HOST_CLASS(Functor)
    virtual std::vector<std::string> getFunctorTypes() const;
    YADE_HOST_ARCHIVE(Serializable, (label))
};
YADE_HOST_KEY(Functor)

namespace sdk {

/// A functor chosen by the class of one object.
template <class Return, class... Parameters>
class SingleFunctor : public Functor, public FunctorSlots<Return, Parameters...> {
public:
    std::vector<std::string> getFunctorTypes() const override { return {get1DFunctorType1()}; }
    virtual std::string get1DFunctorType1() const { return ""; }
};

/// A functor chosen by the classes of two objects.
template <class Return, class... Parameters>
class PairFunctor : public Functor, public FunctorSlots<Return, Parameters...> {
public:
    std::vector<std::string> getFunctorTypes() const override { return {get2DFunctorType1(), get2DFunctorType2()}; }
    virtual std::string get2DFunctorType1() const { return ""; }
    virtual std::string get2DFunctorType2() const { return ""; }
};

}

}

/// Inside a functor's class: the class, or the two classes, that it works on.
#define FUNCTOR1D(Type)                                                                                                \
public:                                                                                                                \
    std::string get1DFunctorType1() const override { return #Type; }
#define FUNCTOR2D(Type1, Type2)                                                                                        \
public:                                                                                                                \
    std::string get2DFunctorType1() const override { return #Type1; }                                                  \
    std::string get2DFunctorType2() const override { return #Type2; }
/// Geometry functors also say in which order they take the two shapes.
#define DEFINE_FUNCTOR_ORDER_2D(Type1, Type2)                                                                          \
public:                                                                                                                \
    std::string checkOrder() const override { return #Type1 " " #Type2; }
