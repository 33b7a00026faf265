// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each thread takes a block of lines, answers it, and hands the answers on, to be written in order. A block ends where
// a read does, so that neither a queue nor a thread that only reads or writes is needed.

#include "record_stream.h"

#include "../Output_file.h"
#include "../option_words.h"
#include "../usage.h"
#include "Line_source.h"
#include "Ordered_output.h"
#include "answer_line.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace bounding_arcs_tool {
namespace {

class Record_stream {
 public:
  Record_stream(Line_source& source, std::ostream& out, const Record_answer& answer)
      : source_(source), output_(out), answer_(answer) {}

  /// Answers blocks until there are no more; run by each thread.
  void work() {
    try {
      Line_block block;
      std::string text;  // whose memory serves all blocks
      while (!output_.has_stopped() && source_.next(block)) answer_block(block, text);
    } catch (...) {  // of reading; what is before it is written by the others
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  /// \return the exit status
  int finish() const {
    if (error_) std::rethrow_exception(error_);
    if (errors_ == 0) return 0;
    std::cerr << "bounding_arcs: " << source_.name() << ": line " << first_error_ << ": " << errors_ << " of "
              << source_.number_of_records() << " records were answered by errors, this line the first\n";
    return 1;
  }

 private:
  // The text is empty before and after.
  void answer_block(const Line_block& block, std::string& text) {
    try {
      for (const Line& line : block.lines) {
        if (!answer_line(line, answer_, text)) count_error(line.number);
        if (text.size() > Ordered_output::MOST_WAITING) output_.put(block.place, text, false);
      }
      output_.put(block.place, text, true);
    } catch (...) {  // out of memory: the others would wait for this block
      output_.stop();
      throw;
    }
  }
  void count_error(std::size_t line) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (errors_++ == 0 || line < first_error_) first_error_ = line;
  }

  Line_source& source_;
  Ordered_output output_;
  const Record_answer& answer_;
  std::mutex mutex_;
  std::size_t errors_ = 0, first_error_ = 0;
  std::exception_ptr error_;
};

}  // namespace

void add_stream_options(CLI::App& command, Stream_options& options, std::string& format) {
  CLI::Option* stream = command.add_flag(
      "--stream", options.is_on,
      "Read a JSON record of a curve, or of several, a line, and write a JSON result a line, in the same order;\n"
      "a bad record is answered by an \"error\", and the exit status is 1 at the end");
  command.add_option("--jobs", options.jobs, "Threads that answer the records of a stream")
      ->needs(stream)
      ->check(whole_number_in(1, 1024))
      ->capture_default_str();
  command.parse_complete_callback([&command, &options, &format] {
    if (!options.is_on) return;
    const std::string output = command.get_option("--output")->as<std::string>(), ending = form_of_ending(output);
    if (command.get_option("--format")->count() > 0) {
      if (format != "json") throw CLI::ValidationError("--format", "expected json with --stream, found " + format);
    } else if (!ending.empty() && ending != "json") {
      throw CLI::ValidationError("--output", expected("a name in .json with --stream, or no known ending", output));
    }
    const CLI::Option* files = command.get_option_no_throw("FILES");
    if (files != nullptr && files->count() > 1 && !options.has_others)
      throw CLI::ValidationError("FILES",
                                 "expected one file, or -, with --stream, found " + std::to_string(files->count()));
    format = "json";
  });
}

int run_stream(const Stream_options& options, const std::string& file, const std::string& output,
               const Record_answer& answer) {
  Line_source source(file);
  Output_file results(output);
  Record_stream stream(source, results.stream(), answer);
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < options.jobs) others.emplace_back([&] { stream.work(); });
  } catch (const std::system_error&) {  // the system has no more threads: the results are the same with fewer
  }
  stream.work();
  for (std::thread& thread : others) thread.join();
  const int status = stream.finish();
  results.commit();
  return status;
}

}  // namespace bounding_arcs_tool
