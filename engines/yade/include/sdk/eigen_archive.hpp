#pragma once

#include <boost/preprocessor/tuple/elem.hpp>
#include <boost/serialization/is_bitwise_serializable.hpp>
#include <boost/serialization/nvp.hpp>

#include <lib/base/Math.hpp>

// Elements and their names are those of YADE's archives.
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector2r)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector2i)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector3r)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector3i)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector6r)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Vector6i)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Quaternionr)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Se3r)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Matrix3r)
BOOST_IS_BITWISE_SERIALIZABLE(yade::Matrix6r)

namespace boost {
namespace serialization {

template <class Archive> void serialize(Archive& archive, yade::Vector2r& v, const unsigned int) {
    archive& make_nvp("x", v[0]) & make_nvp("y", v[1]);
}

template <class Archive> void serialize(Archive& archive, yade::Vector2i& v, const unsigned int) {
    archive& make_nvp("x", v[0]) & make_nvp("y", v[1]);
}

template <class Archive> void serialize(Archive& archive, yade::Vector3r& v, const unsigned int) {
    archive& make_nvp("x", v[0]) & make_nvp("y", v[1]) & make_nvp("z", v[2]);
}

template <class Archive> void serialize(Archive& archive, yade::Vector3i& v, const unsigned int) {
    archive& make_nvp("x", v[0]) & make_nvp("y", v[1]) & make_nvp("z", v[2]);
}

template <class Archive> void serialize(Archive& archive, yade::Quaternionr& q, const unsigned int) {
    archive& make_nvp("w", q.w()) & make_nvp("x", q.x()) & make_nvp("y", q.y()) & make_nvp("z", q.z());
}

template <class Archive> void serialize(Archive& archive, yade::Se3r& se3, const unsigned int) {
    archive& make_nvp("position", se3.position) & make_nvp("orientation", se3.orientation);
}

template <class Archive> void serialize(Archive& archive, yade::Matrix3r& m, const unsigned int) {
    archive& make_nvp("m00", m(0, 0)) & make_nvp("m01", m(0, 1)) & make_nvp("m02", m(0, 2));
    archive& make_nvp("m10", m(1, 0)) & make_nvp("m11", m(1, 1)) & make_nvp("m12", m(1, 2));
    archive& make_nvp("m20", m(2, 0)) & make_nvp("m21", m(2, 1)) & make_nvp("m22", m(2, 2));
}

}
}
