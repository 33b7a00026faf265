// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Wrong usage, in a line: "ARGUMENT: expected X, found Y".

#ifndef BOUNDING_ARCS_TOOL_USAGE_H
#define BOUNDING_ARCS_TOOL_USAGE_H

#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace bounding_arcs_tool {

/// Arguments that do not go together, which only the run of a subcommand tells. The exit status is 2.
/// \code
/// throw Usage_error("--eps", "one tolerance", "\"1,2\"");  // "--eps: expected one tolerance, found "1,2""
/// \endcode
struct Usage_error : std::runtime_error {
  Usage_error(const std::string& argument, const std::string& expected, const std::string& found);
};

/// "a, b or c"
[[nodiscard]] std::string one_of_text(const std::vector<std::string>& words);
/// The text of a check that failed: "expected X, found "WORD"".
[[nodiscard]] std::string expected(const std::string& what, const std::string& word);

/// What is wrong with a command line that could not be parsed. An option that is not known comes first, whatever else
/// is wrong: what was meant by it may be what is missing.
[[nodiscard]] std::string usage_text(const CLI::App& app, const CLI::ParseError& error);

/// Refuses an argument that is empty: a file without a name would be taken for none, or for standard input or output.
/// \throws Usage_error
void check_words(const CLI::App& app);
/// Throws where more than one of the files is "-". \throws Usage_error
void check_inputs(const std::vector<std::string>& files);

}  // namespace bounding_arcs_tool

#endif
