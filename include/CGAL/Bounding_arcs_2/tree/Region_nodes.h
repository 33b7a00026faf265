// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nodes of many binary trees: one bit each, whether it is split, and where that is wanted a number, its thickness.
// Each tree is kept level by level, so the children of its j-th split node are its nodes 2j + 1 and 2j + 2.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_NODES_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_NODES_H

#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// The nodes of subtrees, a bit each: whether it is split. A decider appends to them.
class Region_nodes {
 public:
  /// \param keeps_thickness whether thickness(node) is kept
  explicit Region_nodes(bool keeps_thickness = true) : keeps_thickness_(keeps_thickness) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool keeps_thickness() const { return keeps_thickness_; }
  /// \pre keeps_thickness()
  [[nodiscard]] double thickness(std::size_t node) const { return thickness_[node]; }
  [[nodiscard]] bool is_split(std::size_t node) const { return (split_[node / WORD] >> (node % WORD)) & 1; }
  /// Whether nodes i, ..., i + 63 are split, the lowest bit first. \pre i < size()
  [[nodiscard]] std::uint64_t word(std::size_t i) const {
    const std::size_t used = i % WORD, next = i / WORD + 1;
    const std::uint64_t low = split_[i / WORD] >> used;
    return used == 0 || next == split_.size() ? low : low | split_[next] << (WORD - used);
  }
  [[nodiscard]] std::size_t bytes() const {
    return thickness_.capacity() * sizeof(double) + split_.capacity() * sizeof(std::uint64_t) +
           rank_.capacity() * sizeof(std::size_t);
  }

  /// How many nodes before this one are split. \pre complete() was called
  [[nodiscard]] std::size_t splits_before(std::size_t node) const {
    const std::size_t word = node / WORD, first = word / RANKED * RANKED;
    std::size_t splits = rank_[word / RANKED];
    for (std::size_t i = first; i < word; ++i) splits += internal::count_ones(split_[i]);
    return splits + internal::count_ones(split_[word] & ((std::uint64_t(1) << (node % WORD)) - 1));
  }

  /// Appends up to 64 nodes, at least one, whose lowest bit in `split` stands for the first.
  void append(const double* thickness, std::uint64_t split, std::size_t count) {
    if (keeps_thickness_) thickness_.insert(thickness_.end(), thickness, thickness + count);
    append(split, count);
  }
  /// Appends nodes begin, ..., end - 1 of another, which keeps the thickness if this one does.
  void append(const Region_nodes& other, std::size_t begin, std::size_t end) {
    const std::size_t first = size_;
    resize(size_ + end - begin);
    if (begin < end) split_[first / WORD] |= place(first, other, begin, end);
  }
  /// Appends all nodes of others, at once with Parallel_tag.
  /// \param other other(i) is the i-th of them
  /// \return where each begins, and where they end
  template <class ConcurrencyTag, class Other>
  std::vector<std::size_t> append_all(std::size_t count, const Other& other) {
    std::vector<std::size_t> begins{size_};
    for (std::size_t i = 0; i < count; ++i) begins.push_back(begins.back() + other(i).size());
    resize(begins.back());
    std::vector<std::uint64_t> first_words(count);
    for_each_range<ConcurrencyTag>(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (other(i).size() > 0) first_words[i] = place(begins[i], other(i), 0, other(i).size());
    });
    for (std::size_t i = 0; i < count; ++i)
      if (first_words[i] != 0) split_[begins[i] / WORD] |= first_words[i];
    return begins;
  }
  /// Completes the nodes; to be called when all are there.
  void complete() {
    rank_.assign(split_.size() / RANKED + 1, 0);
    std::size_t splits = 0;
    for (std::size_t i = 0; i < rank_.size(); ++i) {
      rank_[i] = splits;
      for (std::size_t j = RANKED * i; j < (std::min)(RANKED * (i + 1), split_.size()); ++j)
        splits += internal::count_ones(split_[j]);
    }
  }

 private:
  static constexpr std::size_t WORD = 64, RANKED = 8;
  void resize(std::size_t size) {
    size_ = size;
    split_.resize((size + WORD - 1) / WORD);
    if (keeps_thickness_) thickness_.resize(size);
  }
  // Puts nodes begin, ..., end - 1 of another where there are none yet, from node `at` on, but for those in the first
  // word, which may be shared with nodes before them: these are returned. So words are never written for two others at
  // once. \pre begin < end
  [[nodiscard]] std::uint64_t place(std::size_t at, const Region_nodes& other, std::size_t begin, std::size_t end) {
    if (keeps_thickness_)
      std::copy(&other.thickness_[begin], &other.thickness_[begin] + (end - begin), &thickness_[at]);
    const std::size_t used = at % WORD;
    std::uint64_t first_word = 0, *out = &split_[at / WORD];
    for (std::size_t i = begin; i < end; i += WORD, ++out) {
      const std::size_t count = (std::min)(end - i, WORD);
      const std::uint64_t word = other.word(i) & (~std::uint64_t(0) >> (WORD - count));
      (i == begin ? first_word : *out) |= word << used;
      if (used + count > WORD) out[1] = word >> (WORD - used);
    }
    return first_word;
  }
  void append(std::uint64_t split, std::size_t count) {
    const std::size_t used = size_ % WORD;
    if (used == 0) {
      split_.push_back(split);
    } else {
      split_.back() |= split << used;
      if (used + count > WORD) split_.push_back(split >> (WORD - used));
    }
    size_ += count;
  }

  bool keeps_thickness_;
  std::size_t size_ = 0;
  std::vector<double> thickness_;
  std::vector<std::uint64_t> split_;  // bits past the last node are 0
  std::vector<std::size_t> rank_;     // split nodes before words 0, RANKED, 2 RANKED, ...
};
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
