// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command-line tool as tests run it: by a shell, with its output, as text or JSON.

#ifndef BOUNDING_ARCS_TEST_TOOL_H
#define BOUNDING_ARCS_TEST_TOOL_H

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace bounding_arcs_test {

inline const std::vector<std::string> METHODS{"bca", "bilens", "sfa"}, KERNELS{"double", "filtered", "exact"};

/// The eight bundled curves and their numbers of spiral segments, counted exactly elsewhere.
inline const std::vector<std::pair<std::string, int>> BUNDLED{
    {"a_wrench", 75}, {"b_angelfish", 85}, {"c_letter_K", 105}, {"d_rabbit", 116},
    {"e_cat", 120},   {"f_crow", 132},     {"g_chipmunk", 170}, {"h_maple_leaf", 182}};

inline std::string bundled(const std::string& name) {
  return std::string(BOUNDING_ARCS_EXAMPLE_DATA) + '/' + name + ".json";
}

inline std::string all_bundled() {
  std::string files;
  for (const auto& curve : BUNDLED) files += ' ' + bundled(curve.first);
  return files;
}

struct Run {
  int status;
  std::string output;
};

/// Runs the tool with arguments that the shell splits.
inline Run run_tool(const std::string& arguments) {
  const std::string command = std::string("'") + BOUNDING_ARCS_TOOL_PATH + "' " + arguments;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  Run run{-1, ""};
  if (pipe == nullptr) return run;
  std::array<char, 1 << 16> buffer{};
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) run.output.append(buffer.data(), n);
  run.status = ::pclose(pipe);
  return run;
}

inline nlohmann::json json_of(const std::string& arguments) {
  const Run run = run_tool(arguments + " --format json");
  EXPECT_EQ(run.status, 0) << arguments;
  nlohmann::json document = nlohmann::json::parse(run.output, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << arguments << ": no JSON: " << run.output.substr(0, 300);
  return document;
}

/// A curve file of its own for one test.
class Temporary_file {
 public:
  explicit Temporary_file(const std::string& content)
      : path_((std::filesystem::temp_directory_path() / ("tool_output_" + std::to_string(::getpid()) + ".json"))
                  .string()) {
    std::ofstream(path_) << content;
  }
  ~Temporary_file() { std::filesystem::remove(path_); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline void expect_keys(const nlohmann::json& object, const std::set<std::string>& keys) {
  std::set<std::string> found;
  for (const auto& item : object.items()) found.insert(item.key());
  EXPECT_EQ(found, keys) << object.dump().substr(0, 200);
}

}  // namespace bounding_arcs_test

#endif
