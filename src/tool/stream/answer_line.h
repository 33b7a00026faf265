// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line of a stream to the line that answers it.

#ifndef BOUNDING_ARCS_TOOL_STREAM_ANSWER_LINE_H
#define BOUNDING_ARCS_TOOL_STREAM_ANSWER_LINE_H

#include "Line_source.h"
#include "record_stream.h"

#include <string>

namespace bounding_arcs_tool {

/// Appends the answer to a record, with its line's end.
/// \return whether it is a result, not an error
[[nodiscard]] bool answer_line(const Line& line, const Record_answer& answer, std::string& out);

}  // namespace bounding_arcs_tool

#endif
