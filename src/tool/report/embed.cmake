# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The files of a report's page as constants of the tool, made anew when one of them changes.

set(BOUNDING_ARCS_PAGE_SCRIPT "")
foreach(part IN ITEMS head.html body.html page.css tree.js arcs.js view.js plot.js tables.js page.js)
  set(path ${CMAKE_CURRENT_LIST_DIR}/page/${part})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} text)
  string(MAKE_C_IDENTIFIER BOUNDING_ARCS_PAGE_${part} name)
  set(${name} "${text}")
  if(part MATCHES "[.]js$")
    string(APPEND BOUNDING_ARCS_PAGE_SCRIPT "${text}")
  endif()
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/page_parts.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp @ONLY)
target_sources(bounding_arcs PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp)
