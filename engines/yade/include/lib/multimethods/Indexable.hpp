#pragma once

#include <stdexcept>

namespace yade {

/// A class with a small number of its own, by which YADE picks functors. Bodies are inline: YADE exports none of them.
class Indexable {
protected:
    void createIndex() {
        int& index = modifyClassIndex();
        if (index != -1)
            return;
        index = getMaxCurrentlyUsedClassIndexOfKin() + 1;
        incrementMaxCurrentlyUsedClassIndexOfKin();
    }
    virtual void incrementMaxCurrentlyUsedClassIndexOfKin() { unregistered(); }
    virtual int& modifyClassIndex() { unregistered(); }

public:
    Indexable() {}
    virtual ~Indexable() {}
    virtual const int& getClassIndex() const { unregistered(); }
    virtual const int& getBaseClassIndex(int) const { unregistered(); }
    virtual const int& getMaxCurrentlyUsedClassIndexOfKin() const { unregistered(); }

private:
    [[noreturn]] static void unregistered() { throw std::logic_error("indexable class without REGISTER_CLASS_INDEX"); }
};

}

/// Inside the class body: an index of its own below YADE's (or a plugin's) class Base.
#define REGISTER_CLASS_INDEX(Class, Base)                                                                              \
public:                                                                                                                \
    static int& modifyClassIndexStatic() {                                                                             \
        static int index = -1;                                                                                         \
        return index;                                                                                                  \
    }                                                                                                                  \
    static const int& getClassIndexStatic() { return modifyClassIndexStatic(); }                                       \
    int& modifyClassIndex() override { return modifyClassIndexStatic(); }                                              \
    const int& getClassIndex() const override { return getClassIndexStatic(); }                                        \
    const int& getBaseClassIndex(int depth) const override {                                                           \
        static Base* const base = new Base; /* never freed: asked for until the process ends */                        \
        return depth == 1 ? base->getClassIndex() : base->getBaseClassIndex(depth - 1);                                \
    }
