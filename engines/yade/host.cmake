# Target yade_interface: what a source needs that includes YADE's headers. All that differs between supported YADEs is
# chosen here, by version and architecture.

set(GRUS_YADE_SOURCE "" CACHE PATH "YADE source tree whose headers replace engines/yade/include")
set(GRUS_YADE_VERSION "2023.02a" CACHE STRING "Version of YADE to build for; has a table in engines/yade/layout")
set(GRUS_YADE_LAYOUT ${CMAKE_CURRENT_LIST_DIR}/layout/${GRUS_YADE_VERSION}-amd64.json)
if(NOT EXISTS ${GRUS_YADE_LAYOUT})
  message(FATAL_ERROR "GRUS_YADE_VERSION is ${GRUS_YADE_VERSION}, which has no table ${GRUS_YADE_LAYOUT}")
endif()

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
set(GRUS_BOOST_PYTHON python${Python3_VERSION_MAJOR}${Python3_VERSION_MINOR})
find_package(Boost REQUIRED COMPONENTS serialization ${GRUS_BOOST_PYTHON})

add_library(yade_interface INTERFACE)
target_compile_definitions(yade_interface INTERFACE
  EIGEN_DONT_ALIGN EIGEN_DONT_VECTORIZE EIGEN_DONT_PARALLELIZE EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT
  BOOST_BIND_GLOBAL_PLACEHOLDERS)
target_link_libraries(yade_interface INTERFACE
  Eigen3::Eigen Python3::Module Boost::serialization Boost::${GRUS_BOOST_PYTHON})

if(GRUS_YADE_SOURCE)
  # The same classes with a YADE's own headers, for a YADE that was built with other options or is of another version.
  # Pass the macros that this YADE was configured with (YADE_OPENMP, YADE_MPI, ...) in CMAKE_CXX_FLAGS. Only sdk/ is
  # taken from here: module list and registration.
  target_include_directories(yade_interface INTERFACE ${GRUS_YADE_SOURCE} ${CMAKE_CURRENT_LIST_DIR}/include)
  target_compile_options(yade_interface INTERFACE "SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/source_tree.hpp")
  set(GRUS_HOST_SOURCES ${CMAKE_CURRENT_LIST_DIR}/registration.cpp ${CMAKE_CURRENT_LIST_DIR}/source_tree_guard.cpp)
  return()
endif()

# The layout table as C++: assertions on the headers, and what the load guard compares.
set(GRUS_GENERATED ${CMAKE_CURRENT_BINARY_DIR}/yade)
file(MAKE_DIRECTORY ${GRUS_GENERATED})
foreach(part asserts probes)
  set(script ${CMAKE_CURRENT_LIST_DIR}/generate_${part}.py)
  add_custom_command(
    OUTPUT ${GRUS_GENERATED}/layout_${part}.hpp
    COMMAND ${Python3_EXECUTABLE} ${script} ${GRUS_YADE_LAYOUT} > ${GRUS_GENERATED}/layout_${part}.hpp
    DEPENDS ${script} ${GRUS_YADE_LAYOUT} VERBATIM)
endforeach()
target_include_directories(yade_interface INTERFACE ${CMAKE_CURRENT_LIST_DIR}/include ${GRUS_GENERATED})
set(GRUS_HOST_SOURCES
  ${CMAKE_CURRENT_LIST_DIR}/asserts.cpp
  ${CMAKE_CURRENT_LIST_DIR}/guard.cpp
  ${CMAKE_CURRENT_LIST_DIR}/guard_table.cpp
  ${CMAKE_CURRENT_LIST_DIR}/registration.cpp
  ${GRUS_GENERATED}/layout_asserts.hpp
  ${GRUS_GENERATED}/layout_probes.hpp)
