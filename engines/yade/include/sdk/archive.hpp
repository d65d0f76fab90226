#pragma once

// The four archive formats of O.save() and O.load(); they must be known before any class is exported to them.
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/archive/xml_iarchive.hpp>
#include <boost/archive/xml_oarchive.hpp>

#include <boost/serialization/base_object.hpp>
#include <boost/serialization/export.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/nvp.hpp>
#include <boost/serialization/shared_ptr.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>

#include <sdk/eigen_archive.hpp>

#define YADE_HOST_ARCHIVED_(r, unused, member)                                                                         \
    archive& boost::serialization::make_nvp(BOOST_PP_STRINGIZE(member), member);

/// Inside a class of YADE: its archived members, in YADE's order, after its base. Derived classes instantiate this
/// although YADE's own code runs in the end.
#define YADE_HOST_ARCHIVE(Base, members)                                                                               \
    template <class Archive> void serialize(Archive& archive, const unsigned int) {                                    \
        archive& boost::serialization::make_nvp(#Base, boost::serialization::base_object<Base>(*this));                \
        BOOST_PP_SEQ_FOR_EACH(YADE_HOST_ARCHIVED_, ~, members)                                                         \
    }

/// At the end of namespace yade: the name under which archives know one of YADE's classes.
#define YADE_HOST_KEY(Class)                                                                                           \
    }                                                                                                                  \
    BOOST_CLASS_EXPORT_KEY2(yade::Class, "yade::" #Class)                                                              \
    namespace yade {
