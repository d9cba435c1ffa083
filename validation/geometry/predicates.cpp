// Compares the contact predicates with MPFR on millions of inputs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "geometry/contact_predicates.hpp"
#include "geometry/numeric_environment.hpp"
#include "validation/geometry/contact_cases.hpp"
#include "validation/geometry/contact_oracle.hpp"

namespace blocks::validation {
namespace {

/// The counts of one family.
struct Count {
  long inputs = 0, answers = 0;
  long undecided = 0;  ///< answers that a filter could not decide
  long multiprecision =
      0;  ///< of these, those that exact sums of doubles could not decide
  long wrong = 0;
  long plain = 0;         ///< wrong answers of plain doubles
  long first_wrong = -1;  ///< number of the first wrong input

  void add(const Count& other) {
    inputs += other.inputs, answers += other.answers, undecided += other.undecided;
    multiprecision += other.multiprecision, wrong += other.wrong;
    plain += other.plain;
    if (first_wrong < 0)
      first_wrong = other.first_wrong;
  }
};

/// Compares the answers of all predicates for one input.
class Examination {
 public:
  Examination(const ContactCase& input, long number, Count& count)
      : k_(input), truth_(judge(input)), number_(number), count_(count) {
    ++count_.inputs;
  }

  void run() {
    namespace g = geometry;
    namespace f = geometry::filter;
    const Vec2 &c = k_.c, &p1 = k_.p1, &p2 = k_.p2, &q1 = k_.q1, &q2 = k_.q2;
    const Vec2 &centroid = k_.centroid, &neighbour = k_.neighbour;
    compare(
        truth_.overlap_sign, [&] { return g::overlap_sign(c, p1, p2); },
        f::sign(f::overlap(c, p1, p2).value));
    compare(
        yes(truth_.near_or_inside), [&] { return yes(g::near_or_inside(c, p1, p2)); },
        yes(f::near_or_inside(c, p1, p2).value >= 0));
    compare(
        yes(truth_.between), [&] { return yes(g::between(c, p1, p2)); },
        yes(f::between(c, p1, p2).value >= 0));
    compare(
        truth_.turn_sign, [&] { return g::turn_sign(centroid, c, p1, p2); },
        f::sign(f::turn(centroid, c, p1, p2).value));
    compare(
        yes(truth_.faces_edge),
        [&] { return yes(g::faces_edge(c, neighbour, p1, p2)); },
        yes(f::faces_edge(c, neighbour, p1, p2).value >= 0));
    compare(
        truth_.compare_depths, [&] { return g::compare_depths(c, p1, p2, c, q1, q2); },
        f::sign(f::depth_difference(c, p1, p2, c, q1, q2).value));
  }

 private:
  static int yes(bool answer) { return answer ? 1 : -1; }

  /// plain: the answer by the sign of the filter's value, without its bound.
  template <class Predicate>
  void compare(int right, const Predicate& predicate, int plain) {
    const auto calls = geometry::exact::calls();
    const auto multiprecision = geometry::exact::multiprecision_calls();
    const bool wrong = predicate() != right;
    ++count_.answers;
    count_.wrong += wrong;
    count_.plain += plain != right;
    if (wrong && count_.first_wrong < 0)
      count_.first_wrong = number_;
    count_.undecided += static_cast<long>(geometry::exact::calls() - calls);
    count_.multiprecision +=
        static_cast<long>(geometry::exact::multiprecision_calls() - multiprecision);
  }

  ContactCase k_;
  ContactTruth truth_;
  long number_;
  Count& count_;
};

using Counts = std::array<Count, contact_family_count>;

/// Examines all families. The threads take portions of 4096 inputs of one family each.
Counts examine_all(long inputs, int threads) {
  struct Portion {
    std::size_t family;
    long first, last;
  };
  std::vector<Portion> portions;
  for (std::size_t f = 0; f < contact_family_count; ++f) {
    const long count = inputs * contact_families()[f].weight / 100;
    for (long first = 0; first < count; first += 4096)
      portions.push_back({f, first, std::min(first + 4096, count)});
  }
  std::atomic<std::size_t> next = 0;
  std::vector<Counts> parts(static_cast<std::size_t>(threads));
  std::vector<std::thread> workers;
  for (Counts& part : parts)
    workers.emplace_back([&] {
      for (std::size_t p; (p = next.fetch_add(1)) < portions.size();)
        for (long n = portions[p].first; n < portions[p].last; ++n)
          Examination(contact_families()[portions[p].family].make(
                          static_cast<std::uint64_t>(n)),
                      n, part[portions[p].family])
              .run();
    });
  for (std::thread& worker : workers)
    worker.join();
  Counts all;
  for (const Counts& part : parts)
    for (std::size_t f = 0; f < contact_family_count; ++f)
      all[f].add(part[f]);
  return all;
}

void row(std::ostream& out, const std::string& name, const Count& count) {
  out << "| " << name << " | " << count.inputs << " | " << count.answers << " | "
      << count.plain << " | " << count.undecided << " | " << count.multiprecision
      << " | " << count.wrong << " |\n";
}

std::string markdown(const Counts& counts) {
  std::ostringstream out;
  out << R"(# The contact predicates against MPFR

Written by `./go validate predicates`; do not edit. Each input is a corner with a tangent,
two edges and a centroid. It is tested with six predicates. The judge uses the definitions
in MPFR with enough bits to make every sum and product exact. It shares nothing with the
filters, with the exact sums of doubles or with CGAL. *Plain wrong*: wrong answers of the
same formulas in doubles without a bound. *Undecided*: how often a filter left the sign
open. *Multiprecision*: how often multiple-precision numbers were needed because exact
sums of a few doubles were not enough (possibly more than once per answer).

| family | inputs | answers | plain wrong | undecided | multiprecision | wrong |
|---|---|---|---|---|---|---|
)";
  Count total;
  for (std::size_t f = 0; f < contact_family_count; ++f) {
    row(out, contact_families()[f].name, counts[f]);
    total.add(counts[f]);
  }
  row(out, "**all**", total);
  return out.str();
}

int run(int argc, char** argv) {
  CLI::App app{"the contact predicates against MPFR"};
  long inputs = 10000000;
  int threads = 2;
  std::string report;
  app.add_option("--inputs", inputs, "number of inputs")
      ->check(CLI::Range(100L, 1000000000L));
  app.add_option("--threads", threads, "number of threads")->check(CLI::Range(1, 1024));
  app.add_option("--report", report, "write NAME.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (const std::string fault = geometry::check_numeric_environment(); !fault.empty()) {
    std::cerr << "blocks: error: " << fault << "\n";
    return 1;
  }
  const Counts counts = examine_all(inputs, threads);
  const std::string text = markdown(counts);
  std::cout << text;
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << text;
    out.flush();
    if (!out) {
      std::cerr << "blocks: error: cannot write " << report << ".md\n";
      return 5;
    }
  }
  bool right = true;
  for (std::size_t f = 0; f < contact_family_count; ++f)
    if (counts[f].wrong > 0) {
      std::cerr << "blocks: error: family '" << contact_families()[f].name
                << "': the first wrong answer is at number " << counts[f].first_wrong
                << "\n";
      right = false;
    }
  return right ? 0 : 4;
}

}  // namespace
}  // namespace blocks::validation

int main(int argc, char** argv) { return blocks::validation::run(argc, argv); }
