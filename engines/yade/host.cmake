# Target yade_interface: what a source needs that includes YADE's headers. All that differs between supported YADEs is
# chosen here, by version and architecture; include/sdk/host_differences.hpp holds what differs in declarations.

set(GRUS_YADE_SOURCE "" CACHE PATH "YADE source tree whose headers replace engines/yade/include")

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
set(GRUS_BOOST_PYTHON python${Python3_VERSION_MAJOR}${Python3_VERSION_MINOR})
find_package(Boost CONFIG REQUIRED COMPONENTS serialization ${GRUS_BOOST_PYTHON})

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

execute_process(
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/pkg/grus/host/locate.py
  OUTPUT_VARIABLE version ERROR_VARIABLE complaint RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
if(failed)
  message(FATAL_ERROR "${complaint}")
endif()
set(layout ${CMAKE_CURRENT_LIST_DIR}/layout/${version}-amd64.json)
if(NOT EXISTS ${layout})
  message(FATAL_ERROR "YADE ${version} is installed, which is not supported: ${layout} is missing")
endif()
message(STATUS "Grus is built for YADE ${version}")
# As a number that headers can compare: 202302 of 2023.02a, 202502 of 2025.2.0.
string(REGEX MATCH "^([0-9]+)\\.0?([0-9])" number ${version})
target_compile_definitions(yade_interface INTERFACE YADE_HOST=${CMAKE_MATCH_1}0${CMAKE_MATCH_2})

# The layout table as C++: assertions on the headers, and what the load guard compares.
set(GRUS_GENERATED ${CMAKE_CURRENT_BINARY_DIR}/yade)
file(MAKE_DIRECTORY ${GRUS_GENERATED})
foreach(part asserts probes)
  set(script ${CMAKE_CURRENT_LIST_DIR}/generate_${part}.py)
  add_custom_command(
    OUTPUT ${GRUS_GENERATED}/layout_${part}.hpp
    COMMAND ${Python3_EXECUTABLE} ${script} ${layout} > ${GRUS_GENERATED}/layout_${part}.hpp
    DEPENDS ${script} ${layout} VERBATIM)
endforeach()
target_include_directories(yade_interface INTERFACE ${CMAKE_CURRENT_LIST_DIR}/include ${GRUS_GENERATED})
set(GRUS_HOST_SOURCES
  ${CMAKE_CURRENT_LIST_DIR}/asserts.cpp
  ${CMAKE_CURRENT_LIST_DIR}/guard.cpp
  ${CMAKE_CURRENT_LIST_DIR}/guard_table.cpp
  ${CMAKE_CURRENT_LIST_DIR}/registration.cpp
  ${GRUS_GENERATED}/layout_asserts.hpp
  ${GRUS_GENERATED}/layout_probes.hpp)
