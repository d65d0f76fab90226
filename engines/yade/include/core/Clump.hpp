#pragma once

#include <core/Body.hpp>
#include <sdk/host_differences.hpp>

namespace yade {

/// Bodies that move as one; the clump body carries the ids and places of its members.
class Clump : public Shape {
public:
    std::map<int, Se3r> members; // place of each member in the clump's axes
    YADE_HOST_CLUMP_IDS

    Clump() { createIndex(); }
    YADE_HOST_CLASS(Clump)
    YADE_HOST_INDEX(Clump)
    /// Makes a standalone body a member, at no particular place yet.
    static void add(const boost::shared_ptr<Body>& clump, const boost::shared_ptr<Body>& member);
    static void del(const boost::shared_ptr<Body>& clump, const boost::shared_ptr<Body>& member);
};

}
