// Names corners, edges and contacts, and states the findings of an audit in words and
// numbers. Blocks, corners and edges are numbered from 1. An edge is named by its first
// corner.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "audit/audit.hpp"

namespace blocks::audit {

/// Returns the number of a corner or an edge in its block, from 1.
int number_in_block(const Blocks& blocks, int corner);

/// Returns "corner 2 of block 5".
std::string name_of(const Blocks& blocks, int corner);

/// Returns "edge 2 of block 5".
std::string name_of_edge(const Blocks& blocks, int edge);

/// Returns "corner 2 of block 5 on edge 1 of block 3; ...", or "no contact". Each
/// contact is a corner and an edge.
std::string contacts_in_words(const Blocks& blocks,
                              const std::vector<std::pair<int, int>>& contacts);

/// Breaks a text at spaces into lines with at most so many columns. The first line is
/// indented, and the others by two columns more.
std::vector<std::string> in_lines(const std::string& text, std::size_t indent,
                                  std::size_t columns);

/// Each of these describes a finding in one line.
std::string tell(const BlockPair& missed);
std::string tell(const Blocks& blocks, const WrongPair& wrong);
std::string tell(const Blocks& blocks, const PlaneFault& fault);
std::string tell(const ExcessOverlap& excess);
std::string tell(const Blocks& blocks, const DeepContact& deep);

}  // namespace blocks::audit
