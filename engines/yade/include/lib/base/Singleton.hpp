#pragma once

/// One object per process. Both members live in YADE's libraries for the classes that Grus reaches through it.
template <class T> class Singleton {
protected:
    static T* self;

public:
    static T& instance();
};
