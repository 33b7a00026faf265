// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// --stream: a JSON record a line in, a JSON result a line out, in the same order; for any subcommand that answers
// curves by a document.

#ifndef BOUNDING_ARCS_TOOL_STREAM_RECORD_STREAM_H
#define BOUNDING_ARCS_TOOL_STREAM_RECORD_STREAM_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Stream_options {
  bool is_on = false;
  std::size_t jobs = 1;     ///< threads
  bool has_others = false;  ///< files behind the first one are read as without a stream
};

/// What errors call the file that a record is not.
inline const char* const RECORD_NAME = "record";

/// Writes the document that the subcommand makes of a file with these curves; several threads call it at once.
using Record_answer = std::function<void(std::vector<CGAL::Bounding_arcs::Curve_record>&& curves, std::ostream& out)>;

/// Adds --stream and --jobs to a subcommand that has --format, and FILE or FILES.
/// \param format becomes json with --stream
void add_stream_options(CLI::App& command, Stream_options& options, std::string& format);

/// Answers all records of a file, "-" for standard input: each by its document on one line, with the record's "id" in
/// front, or by {"line":n,"error":"..."}. Blank lines are left out.
/// \return the exit status, 1 if a record was answered by an error, which is said in a line on standard error
/// \throws Input_error when the file cannot be read, or the results cannot be written
int run_stream(const Stream_options& options, const std::string& file, const std::string& output,
               const Record_answer& answer);

}  // namespace bounding_arcs_tool

#endif
