// All of the physics in one file, for clang-tidy.
#include <physics/ageing.hpp>
#include <physics/bond.hpp>
#include <physics/contact.hpp>
#include <physics/contactoptions.hpp>
#include <physics/hertz.hpp>
#include <physics/hysteresis.hpp>
#include <physics/pairlaw.hpp>
#include <physics/random.hpp>
#include <physics/rolling.hpp>
#include <physics/section.hpp>
#include <physics/servo.hpp>
#include <physics/stiffness.hpp>
#include <physics/strength.hpp>
#include <physics/timestep.hpp>
#include <physics/transport.hpp>
#include <physics/vector.hpp>
