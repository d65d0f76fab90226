#pragma once

// Declarations that repeat in each of YADE's classes. None has a body: code, tables and type information come from
// YADE's libraries. The order of new virtual functions is part of the binary interface.

/// The eight functions that every serializable class of YADE overrides.
#define YADE_HOST_CLASS(Class)                                                                                         \
public:                                                                                                                \
    ~Class() override;                                                                                                 \
    std::string getBaseClassName(unsigned i = 0) const override;                                                       \
    int getBaseClassNumber() const override;                                                                           \
    std::string getClassName() const override;                                                                         \
    void pySetAttr(const std::string& key, const boost::python::object& value) override;                               \
    boost::python::dict pyDict() const override;                                                                       \
    void callPostLoad() override;                                                                                      \
    void pyRegisterClass(boost::python::object scope) override;

/// The index functions of a class below the root of its kind.
#define YADE_HOST_INDEX(Class)                                                                                         \
public:                                                                                                                \
    int& modifyClassIndex() override;                                                                                  \
    const int& getClassIndex() const override;                                                                         \
    const int& getBaseClassIndex(int depth) const override;

/// The index functions of the root of a kind (Shape, Bound, Material, State, IGeom, IPhys).
#define YADE_HOST_INDEX_ROOT(Class)                                                                                    \
    YADE_HOST_INDEX(Class)                                                                                             \
    const int& getMaxCurrentlyUsedClassIndexOfKin() const override;                                                    \
    void incrementMaxCurrentlyUsedClassIndexOfKin() override;
