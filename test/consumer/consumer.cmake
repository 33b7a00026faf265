# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The same in all consumers: a library that passes Bounding Arcs on, and is exported, and a program that links it.
add_library(consumer_regions STATIC ../regions.cpp)
target_link_libraries(consumer_regions PUBLIC Bounding_arcs::Bounding_arcs)
add_executable(consumer ../main.cpp)
target_link_libraries(consumer PRIVATE consumer_regions)

install(TARGETS consumer_regions EXPORT Consumer_regionsConfig ARCHIVE DESTINATION lib)
install(EXPORT Consumer_regionsConfig NAMESPACE Consumer:: DESTINATION lib/cmake/Consumer_regions)
export(EXPORT Consumer_regionsConfig NAMESPACE Consumer::)

# What is this project's own has not been touched.
foreach(variable IN ITEMS CMAKE_BUILD_TYPE CMAKE_CXX_FLAGS CMAKE_CXX_COMPILER_LAUNCHER CMAKE_CXX_STANDARD)
  if(NOT "${${variable}}" STREQUAL "")
    message(FATAL_ERROR "${variable} has become ${${variable}}")
  endif()
endforeach()
