#pragma once

#include <mutex>

#include <core/Interaction.hpp>

namespace yade {

class BodyContainer;

/// O.interactions. Loop over it as over any container; entries are never null, but may be potential contacts.
class InteractionContainer : public Serializable {
public:
    using ContainerT = std::vector<boost::shared_ptr<Interaction>>;
    using iterator = ContainerT::iterator;
    using const_iterator = ContainerT::const_iterator;

    ContainerT linIntrs;
    ContainerT sortedIntrs;
    const std::vector<boost::shared_ptr<Body>>* bodies;
    std::size_t currSize;
    boost::shared_ptr<Interaction> empty;
    ContainerT interaction;
    bool dirty;
    std::mutex drawloopmutex;
    bool serializeSorted;
    long iterColliderLastRun;

    YADE_HOST_CLASS(InteractionContainer)
    iterator begin() { return linIntrs.begin(); }
    iterator end() { return linIntrs.end(); }
    const_iterator begin() const { return linIntrs.begin(); }
    const_iterator end() const { return linIntrs.end(); }
    std::size_t size() { return currSize; }
    boost::shared_ptr<Interaction>& operator[](std::size_t index) { return linIntrs[index]; }
    const boost::shared_ptr<Interaction>& operator[](std::size_t index) const { return linIntrs[index]; }

    // find, insert and erase are not thread-safe.
    /// Null when there is none; the order of the ids does not matter.
    const boost::shared_ptr<Interaction>& find(Body::id_t id1, Body::id_t id2);
    bool insert(const boost::shared_ptr<Interaction>&);
    bool insert(Body::id_t id1, Body::id_t id2);
    bool erase(Body::id_t id1, Body::id_t id2, int linPos);
    /// Resets at once and in place; the entry stays as a potential contact. The only form allowed inside a loop.
    void requestErase(Body::id_t id1, Body::id_t id2);
    void requestErase(const boost::shared_ptr<Interaction>&);
    void requestErase(Interaction*);
    void eraseNonReal();
};

}
