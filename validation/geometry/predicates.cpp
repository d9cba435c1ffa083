// Compares the contact predicates, scalar and in batches, with MPFR on millions of
// inputs.
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

#include "geometry/contact_predicates_batch.hpp"
#include "geometry/numeric_environment.hpp"
#include "validation/geometry/contact_cases.hpp"
#include "validation/geometry/contact_oracle.hpp"

namespace blocks::validation {
namespace {

using geometry::Answers;
using geometry::Points;
constexpr std::size_t lanes = geometry::batch_lanes;

/// The counts of one family.
struct Count {
  long inputs = 0, answers = 0;
  long undecided = 0;  ///< answers that a filter could not decide
  long multiprecision =
      0;  ///< of these, those that exact sums of doubles could not decide
  long wrong = 0, wrong_batch = 0;
  long plain = 0;         ///< wrong answers of plain doubles
  long first_wrong = -1;  ///< number of the first wrong input

  void add(const Count& other) {
    inputs += other.inputs, answers += other.answers, undecided += other.undecided;
    multiprecision += other.multiprecision, wrong += other.wrong;
    wrong_batch += other.wrong_batch, plain += other.plain;
    if (first_wrong < 0)
      first_wrong = other.first_wrong;
  }
};

/// Examines four inputs: each predicate as a scalar and as a batch.
class Examination {
 public:
  Examination(const std::array<ContactCase, lanes>& cases, long number, Count& count)
      : cases_(cases), number_(number), count_(count) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const ContactCase& k = cases[i];
      c_.set(i, k.c), p1_.set(i, k.p1), p2_.set(i, k.p2), q1_.set(i, k.q1);
      q2_.set(i, k.q2), g_.set(i, k.centroid), n_.set(i, k.neighbour);
      truth_[i] = judge(k);
    }
    count_.inputs += static_cast<long>(lanes);
  }

  void run() {
    namespace g = geometry;
    namespace f = geometry::filter;
    using K = const ContactCase&;
    using T = const ContactTruth&;
    compare([](T t) { return t.overlap_sign; },
            [](K k) { return g::overlap_sign(k.c, k.p1, k.p2); },
            g::batch::overlap_sign(c_, p1_, p2_),
            [](K k) { return f::sign(f::overlap(k.c, k.p1, k.p2).value); });
    compare([](T t) { return yes(t.near_or_inside); },
            [](K k) { return yes(g::near_or_inside(k.c, k.p1, k.p2)); },
            g::batch::near_or_inside(c_, p1_, p2_),
            [](K k) { return yes(f::near_or_inside(k.c, k.p1, k.p2).value >= 0); });
    compare([](T t) { return yes(t.between); },
            [](K k) { return yes(g::between(k.c, k.p1, k.p2)); },
            g::batch::between(c_, p1_, p2_),
            [](K k) { return yes(f::between(k.c, k.p1, k.p2).value >= 0); });
    compare([](T t) { return yes(t.within_depth); },
            [](K k) { return yes(g::within_depth(k.c, k.centroid, k.p1, k.p2)); },
            g::batch::within_depth(c_, g_, p1_, p2_),
            [](K k) {
              return yes(f::above_centroid(k.c, k.centroid, k.p1, k.p2).value >= 0);
            });
    compare([](T t) { return yes(t.near_or_inside && t.between && t.within_depth); },
            [](K k) { return yes(g::in_reach_of_edge(k.c, k.centroid, k.p1, k.p2)); },
            g::batch::in_reach_of_edge(c_, g_, p1_, p2_),
            [](K k) {
              return yes(f::in_reach_of_edge(k.c, k.centroid, k.p1, k.p2).value >= 0);
            });
    compare([](T t) { return yes(t.faces_edge); },
            [](K k) { return yes(g::faces_edge(k.c, k.neighbour, k.p1, k.p2)); },
            g::batch::faces_edge(c_, n_, p1_, p2_),
            [](K k) {
              return yes(f::faces_edge(k.c, k.neighbour, k.p1, k.p2).value >= 0);
            });
    compare([](T t) { return t.compare_depth; },
            [](K k) { return g::compare_depth(k.c, k.p1, k.p2, k.q1, k.q2); },
            g::batch::compare_depth(c_, p1_, p2_, q1_, q2_),
            [](K k) {
              return f::sign(
                  f::depth_difference(k.c, k.p1, k.p2, k.c, k.q1, k.q2).value);
            });
  }

 private:
  static int yes(bool answer) { return answer ? 1 : -1; }

  template <class Right, class Scalar, class Plain>
  void compare(Right&& right, Scalar&& scalar, const Answers& batch, Plain&& plain) {
    const auto calls = geometry::exact::calls();
    const auto multiprecision = geometry::exact::multiprecision_calls();
    for (std::size_t i = 0; i < lanes; ++i) {
      const int expected = right(truth_[i]);
      const bool wrong = scalar(cases_[i]) != expected;
      const bool wrong_batch =
          !batch.undecided(i) && (batch.yes(i) ? 1 : -1) != expected;
      ++count_.answers;
      count_.wrong += wrong;
      count_.wrong_batch += wrong_batch;
      count_.plain += plain(cases_[i]) != expected;
      if ((wrong || wrong_batch) && count_.first_wrong < 0)
        count_.first_wrong = number_ + static_cast<long>(i);
    }
    count_.undecided += static_cast<long>(geometry::exact::calls() - calls);
    count_.multiprecision +=
        static_cast<long>(geometry::exact::multiprecision_calls() - multiprecision);
  }

  const std::array<ContactCase, lanes>& cases_;
  long number_;
  Count& count_;
  Points c_, p1_, p2_, q1_, q2_, g_, n_;
  std::array<ContactTruth, lanes> truth_;
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
    const long count = std::max(static_cast<long>(lanes),
                                inputs * contact_families()[f].weight / 100 / 4 * 4);
    for (long first = 0; first < count; first += 4096)
      portions.push_back({f, first, std::min(first + 4096, count)});
  }
  std::atomic<std::size_t> next = 0;
  std::vector<Counts> parts(static_cast<std::size_t>(threads));
  std::vector<std::thread> workers;
  for (Counts& part : parts)
    workers.emplace_back([&] {
      for (std::size_t p; (p = next.fetch_add(1)) < portions.size();)
        for (long n = portions[p].first; n < portions[p].last;
             n += static_cast<long>(lanes)) {
          std::array<ContactCase, lanes> cases;
          for (std::size_t i = 0; i < lanes; ++i)
            cases[i] = contact_families()[portions[p].family].make(
                static_cast<std::uint64_t>(n) + i);
          Examination(cases, n, part[portions[p].family]).run();
        }
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
      << " | " << count.wrong << " | " << count.wrong_batch << " |\n";
}

std::string markdown(const Counts& counts) {
  std::ostringstream out;
  out << R"(# The contact predicates against MPFR

Written by `./go validate predicates`; do not edit. Each input is a corner with a tangent,
two edges and a centroid. It is tested with seven predicates (six, and
`in_reach_of_edge`), scalar and as a lane of a batch. The judge uses the definitions in
MPFR with enough bits to make every sum and product exact. It shares nothing with the
filters, with the exact sums of doubles or with CGAL. *Plain wrong*: wrong answers of the
same formulas in doubles without a bound. *Undecided*: how often a filter left the sign
open. *Multiprecision*: how often multiple-precision numbers were needed because exact
sums of a few doubles were not enough (possibly more than once per answer). A lane of a
batch is wrong if it is decided and wrong.

| family | inputs | answers | plain wrong | undecided | multiprecision | wrong | wrong lanes |
|---|---|---|---|---|---|---|---|
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
    if (counts[f].wrong + counts[f].wrong_batch > 0) {
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
