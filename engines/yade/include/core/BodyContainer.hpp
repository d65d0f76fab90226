#pragma once

#include <mutex>

#include <core/Body.hpp>

namespace yade {

/// O.bodies. Iterate over the member body and skip its empty entries.
class BodyContainer : public Serializable {
public:
    std::vector<boost::shared_ptr<Body>> body; // index is the id; null after erasing
    bool dirty;
    bool checkedByCollider;
    std::vector<Body::id_t> insertedBodies;
    std::vector<Body::id_t> erasedBodies;
    std::vector<Body::id_t> realBodies;
    bool useRedirection;
    bool enableRedirection;
    std::vector<Body::id_t> subdomainBodies;
    std::mutex drawloopmutex;

    YADE_HOST_CLASS(BodyContainer)
    Body::id_t insert(boost::shared_ptr<Body>);
    std::size_t size() const;
    boost::shared_ptr<Body>& operator[](unsigned int id);
    const boost::shared_ptr<Body>& operator[](unsigned int id) const;
    bool exists(Body::id_t id) const;
    /// Also erases the body's interactions: never inside a loop over bodies or interactions.
    bool erase(Body::id_t id, bool eraseClumpMembers);
    void updateRealBodies();
};

}
