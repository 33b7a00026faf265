// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "usage.h"

#include "../input/Input_text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace bounding_arcs_tool {
namespace {

using Names = std::vector<std::string>;

// How many letters have to be put in, left out, changed, or swapped with the next one.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = (std::min)({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = (std::min)(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

// The name that is nearest to a word, "" if none is near. A word that begins a name, or goes on behind it, is near.
std::string meant(const std::string& word, const Names& names) {
  constexpr std::size_t OF_WORD = 3, LEAST_BEGINNING = 3;
  std::string best;
  std::size_t fewest = (std::max)(word.size() / OF_WORD, std::size_t(1)) + 1;
  for (const std::string& name : names)
    if (const std::size_t n = edits(word, name); n < fewest) {
      fewest = n;
      best = name;
    }
  const auto is_beginning = [&](const std::string& name) {
    const std::size_t common = (std::min)(word.size(), name.size());
    return common >= LEAST_BEGINNING && word.compare(0, common, name, 0, common) == 0;
  };
  if (best.empty())
    if (const auto found = std::find_if(names.begin(), names.end(), is_beginning); found != names.end()) best = *found;
  return best;
}

Names options_of(const CLI::App& command) {
  Names names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  return names;
}

Names subcommands_of(const CLI::App& command) {
  Names names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

/// The subcommand that was asked for, and how it is called.
struct Asked {
  const CLI::App* command;
  std::string call;
};
Asked asked(const CLI::App& app) {
  Asked result{&app, app.get_name()};
  while (!result.command->get_subcommands().empty()) {
    result.command = result.command->get_subcommands().front();
    result.call += ' ' + result.command->get_name();
  }
  return result;
}

std::string question(const std::string& name) { return name.empty() ? "" : "; did you mean " + name + "?"; }

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && std::isdigit(static_cast<unsigned char>(word[1])) == 0 && word[1] != '.';
}

std::string unknown_option(const std::string& word, const Asked& asked) {
  const std::string option = word.substr(0, word.find('='));
  const std::size_t dashes = option.find_first_not_of('-');
  const std::string name = meant(dashes == std::string::npos ? "" : option.substr(dashes), options_of(*asked.command));
  if (option == "--" + name) return option + ": expected behind `" + asked.call + "`, found in front of it";
  return option + ": unknown option" + (name.empty() ? ";" : question("--" + name)) + " `" + asked.call +
         " --help` lists the options";
}

std::string wrong_subcommand(const Names& extras, const Asked& asked) {
  const Names names = subcommands_of(*asked.command);
  const std::string expected = "SUBCOMMAND: expected " + one_of_text(names) + ", found ";
  if (extras.empty()) return expected + "nothing";
  return expected + in_quotes(extras.front()) + question(meant(extras.front(), names));
}

std::string missing(const CLI::ParseError& error, const Asked& asked) {
  for (const CLI::Option* option : asked.command->get_options())
    if (option->get_required() && option->count() == 0)
      return option->get_name() + ": expected " + (option->get_positional() ? "an argument" : "this option") +
             ", found none; see `" + asked.call + " --help`";
  return error.what();
}

// CLI11 tells the argument in front of a colon or a space.
std::string argument_of(const CLI::ParseError& error) {
  const std::string text = error.what();
  return text.substr(0, text.find_first_of(": "));
}

}  // namespace

Usage_error::Usage_error(const std::string& argument, const std::string& expected, const std::string& found)
    : std::runtime_error(argument + ": expected " + expected + ", found " + found) {}

std::string one_of_text(const Names& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_last = i + 1 == words.size();
    text += (i == 0 ? "" : (is_last ? " or " : ", ")) + words[i];
  }
  return text;
}

std::string expected(const std::string& what, const std::string& word) {
  return "expected " + what + ", found " + in_quotes(word);
}

std::string usage_text(const CLI::App& app, const CLI::ParseError& error) {
  const Asked a = asked(app);
  const Names extras = app.remaining(true);
  if (const auto option = std::find_if(extras.begin(), extras.end(), is_option); option != extras.end())
    return unknown_option(*option, a);
  if (!subcommands_of(*a.command).empty()) return wrong_subcommand(extras, a);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing(error, a);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extras.empty())
    return in_quotes(extras.front()) + ": expected no further argument, found this one; see `" + a.call + " --help`";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string name = argument_of(error);
    const CLI::Option* option = a.command->get_option_no_throw(name);
    const bool is_repeated = option != nullptr && option->count() > 1;
    return name + ": expected " +
           (is_repeated ? "one value, found " + std::to_string(option->count()) : "a value, found none");
  }
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    const std::string text = error.what(), needed = text.substr(text.rfind(' ') + 1);
    return argument_of(error) + ": expected together with " + needed + ", found without";
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    const std::string text = error.what(), other = text.substr(text.rfind(' ') + 1);
    return argument_of(error) + ": expected without " + other + ", found with it";
  }
  return error.what();
}

void check_words(const CLI::App& app) {
  for (const CLI::Option* option : asked(app).command->get_options()) {
    if (option->get_expected_min() == 0) continue;  // flags, and options that need no value
    const Names& words = option->results();
    if (std::find(words.begin(), words.end(), "") != words.end())
      throw Usage_error(option->get_name(), "a value", in_quotes(""));
  }
}

void check_inputs(const std::vector<std::string>& files) {
  const auto count = std::count(files.begin(), files.end(), "-");
  if (count > 1) throw Usage_error("-", "one input from standard input", std::to_string(count));
}

}  // namespace bounding_arcs_tool
